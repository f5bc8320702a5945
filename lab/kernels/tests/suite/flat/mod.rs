//! The kernels of flat shapes: triangles, rectangles, planes.

mod leaks;
mod rays;
mod rectangle;
mod triangle;
mod watertight;
