/* What FFTW has measured, kept from run to run: $XDG_CACHE_HOME/frana/ or ~/.cache/frana/, one file. */
#pragma once

/* Rank 0 reads the file, if there is one, and all ranks plan by it. Collective. */
void fluid_wisdom_load(void);
/* Rank 0 writes what it knows by now, if that is more than was loaded; a folder that cannot be written is passed over.
 * A reader sees the old file or the new one, never a part. Not collective. */
void fluid_wisdom_store(void);
