/* FFTW's measured plans ("wisdom"), stored in one cache file: in $XDG_CACHE_HOME/frana/ or ~/.cache/frana/. */
#pragma once

/* Rank 0 reads the file, if it exists, and all ranks use its plans. Collective. */
void fluid_wisdom_load(void);
/* Rank 0 writes its plans if there are more than were loaded; it does nothing if the folder is not writable. A reader
 * sees the old file or the new one, never a part. Not collective. */
void fluid_wisdom_store(void);
