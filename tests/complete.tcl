# leaves with 1 if a file is not a complete Tcl script
set file [open [lindex $argv 0]]
set script [read $file]
if {![info complete $script]} {
    puts stderr "not complete: a brace or a quote is open"
    exit 1
}
