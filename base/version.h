/* Version, git revision, compiler and flags of this build. */
#pragma once
#include "frana_version.h"
