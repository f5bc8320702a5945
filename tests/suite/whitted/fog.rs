//! Fog, compared with the reference.

use scenes::{Fog, Scene};

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, compared};

const SIZE: (u32, u32) = (160, 120);

/// Shapes of all kinds from near to far, with a mirror and glass, before a sky.
fn scene() -> Scene {
    let text = "v\nfrom 0 3 -12\nat 0 1 0\nup 0 1 0\nangle 45\nhither 0\nresolution 320 240\n\
        b 0.3 0.4 0.9\n#cellray sky 0.1 0.2 0.5\nl 20 40 -30 0.9 0.9 0.9\n\
        #cellray ambient 0.2 0.2 0.2\n#cellray fog 0.9 0.6 0.4 0.04\n\
        f 0.5 0.6 0.3 1 0 1 0 1\np 4\n-60 0 -20\n-60 0 60\n60 0 60\n60 0 -20\n\
        p 3\n-9 0 9\n-5 0 9\n-7 5 9\nc\n5 0 20 2\n5 4 20 1\n\
        f 0.9 0.2 0.1 0.4 0.6 30 0 1\ns -3 1.5 0 1.5\ns 4 1.5 10 1.5\ns -8 1.5 30 1.5\n\
        f 0.9 0.9 0.9 0.1 0.1 30 0.8 1.5\ns 1 1.2 -2 1.2\n";
    scenes::parse(text.as_bytes(), "fog", &scenes::Limits::default()).unwrap()
}

#[test]
fn fog_is_as_the_reference_has_it() {
    for density in [0.0, 0.004, 0.04, 1.0, 1e9] {
        let mut scene = scene();
        scene.fog = scene.fog.map(|fog| Fog { density, ..fog });
        let result = compared(&scene, WHITTED, SIZE);
        assert!(result.max_error_off_silhouette <= 2, "{density}: {result:?}");
        assert!(result.wrong_fraction <= 0.0015, "{density}: {result:?}");
    }
}

/// The densest fog hides all but what is beyond, and none is what a density of 0 is.
#[test]
fn fog_hides_surfaces_and_no_sky() {
    let picture = |fog: Option<Fog>| {
        let scene = Scene { fog, ..scene() };
        Frame::of(&scene, WHITTED, SIZE, Settings::default()).picture
    };
    let colour = DVec3::new(1.0, 0.0, 0.0);
    let [none, thin, thick] = [None, Some(0.0), Some(1e9)]
        .map(|density| picture(density.map(|density| Fog { colour, density })));
    assert!(none == thin);
    let [mut hidden, mut same] = [0, 0];
    for (before, after) in none.pixels().zip(thick.pixels()) {
        hidden += usize::from(after.0 == [255, 0, 0]);
        same += usize::from(after == before);
    }
    assert_eq!(hidden + same, none.pixels().len());
    assert!(hidden > 5000 && same > 3000, "{hidden} {same}");
}
