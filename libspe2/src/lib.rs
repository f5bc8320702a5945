//! libspe2 on the emulator.
