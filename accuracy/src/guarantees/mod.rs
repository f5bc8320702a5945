//! What holds of whole scenes: meshes without leaks, rays that leave cleanly, symmetric shadows.
