//! The camera against rays worked out by hand.

use glam::DVec3;
use scenes::{View, ViewError};

/// From (0, -10, 0) along +y with z up: right is +x.
fn view(angle: f64) -> View {
    View {
        from: DVec3::new(0.0, -10.0, 0.0),
        at: DVec3::ZERO,
        up: DVec3::new(0.0, 7.0, 0.5),
        angle,
        hither: 0.0,
        resolution: (64, 48),
    }
}

fn close(found: DVec3, expected: DVec3) {
    assert!(found.distance(expected) < 1e-12, "{found} is not {expected}");
}

#[test]
fn angle_is_between_centres_of_outer_rows() {
    // 90 degrees: from -1 to 1 over ten gaps, so 0.2 a pixel both ways.
    let camera = view(90.0).camera(21, 11).expect("a camera");
    close(camera.eye, DVec3::new(0.0, -10.0, 0.0));
    close(camera.right, DVec3::new(0.2, 0.0, 0.0));
    close(camera.down, DVec3::new(0.0, 0.0, -0.2));
    close(camera.corner, DVec3::new(-2.0, 1.0, 1.0));
    close(camera.direction(10, 5), DVec3::Y);
    close(camera.direction(20, 10), DVec3::new(2.0, 1.0, -1.0));
}

#[test]
fn even_size_has_centre_between_pixels() {
    let camera = view(90.0).camera(2, 2).expect("a camera");
    close(camera.direction(0, 0), DVec3::new(-1.0, 1.0, 1.0));
    close(camera.direction(1, 1), DVec3::new(1.0, 1.0, -1.0));
}

#[test]
fn one_pixel_and_one_row_have_views() {
    close(view(45.0).camera(1, 1).expect("a camera").corner, DVec3::Y);
    let row = view(90.0).camera(5, 1).expect("a camera");
    close(row.direction(0, 0), DVec3::new(-1.0, 1.0, 0.0));
    close(row.direction(4, 0), DVec3::new(1.0, 1.0, 0.0));
    let column = view(90.0).camera(1, 3).expect("a camera");
    close(column.direction(0, 2), DVec3::new(0.0, 1.0, -1.0));
}

#[test]
fn view_is_independent_of_vector_lengths() {
    let mut far = view(60.0);
    far.at = DVec3::new(0.0, 1e150, 0.0);
    far.up = DVec3::new(0.0, 0.0, 5e-324);
    let (found, expected) =
        (far.camera(8, 8).expect("far"), view(60.0).camera(8, 8).expect("near"));
    close(found.corner, expected.corner);
    close(found.down, expected.down);
}

#[test]
fn empty_sizes_are_refused() {
    for (width, height) in [(0, 1), (1, 0), (scenes::MAX_SIDE + 1, 1), (1, u32::MAX)] {
        assert_eq!(
            view(45.0).camera(width, height),
            Err(ViewError::Size(format!("{width}x{height}")))
        );
    }
    assert!(view(f64::NAN).camera(1, 1).is_err());
}
