//! Tests of a device's options: video modes, fewer frames, and releasing the screen.

use super::super::super::Raster;
use super::script::Call::{Fsel, Getmode, Off, On, Screeninfo, Setmode, Vsync};
use super::*;

const BORDERED: Options = Options {
    size: None,
    raster: Some(Raster::Bordered),
    mode: None,
    two_frames: true,
    vsync: true,
};

#[test]
fn video_mode_is_changed_first_and_restored_last() {
    let bordered = Script::new("ps3fb", 1124, 644, 4544, 9 * MIB - 0x1_0000);
    let mut script = Script::ps3fb();
    script.mode = 131;
    script.other_mode = Some((bordered.var, bordered.fix));
    let (device, witness) = script.open_with(BORDERED);
    let mut device = device.unwrap();
    assert_eq!(device.geometry(), Geometry::new(1124, 644).unwrap());
    show(&mut device, 3);
    witness.assert_shows(device.geometry(), 4544, 0, 3);
    drop(device);
    assert_eq!(
        witness.calls(),
        [Getmode, Setmode(3), Screeninfo, On, Fsel(1), Vsync, Fsel(0), Off, Setmode(131)]
    );
    // A mode that is already set is not set again.
    let (device, witness) = bordered.open_with(BORDERED);
    drop(device.unwrap());
    assert_eq!(witness.calls(), [Getmode, Screeninfo, On, Fsel(1), Off]);
}

#[test]
fn size_missing_in_new_mode_restores_old_mode() {
    let mut script = Script::ps3fb();
    script.mode = 131;
    let (device, witness) =
        script.open_with(Options { size: Some(Geometry::new(640, 480).unwrap()), ..BORDERED });
    assert!(matches!(device.err().unwrap(), FramebufferError::SizeMismatch { .. }));
    assert_eq!(witness.calls(), [Getmode, Setmode(3), Setmode(131)]);
}

#[test]
fn unavailable_video_modes_are_errors() {
    let other = Script::new("vesafb", 64, 48, 256, 256 * 48);
    let mut monitor = Script::ps3fb();
    monitor.mode = 12;
    let mut refusing = Script::ps3fb().failing([(Setmode(3), libc::ENOMEM)]);
    refusing.mode = 131;
    let unknown = Script::ps3fb().failing([(Getmode, libc::ENOTTY)]);
    let cases = [
        (other, "vesafb", vec![]),
        (monitor, "monitor", vec![Getmode]),
        (refusing, "SETMODE 3", vec![Getmode, Setmode(3)]),
        (unknown, "GETMODE", vec![Getmode]),
    ];
    for (script, part, calls) in cases {
        let (device, witness) = script.open_with(BORDERED);
        let text = device.err().unwrap().to_string();
        assert!(text.contains(part) && text.contains("mode with borders"), "{part}: {text}");
        assert_eq!(witness.calls(), calls);
    }
}

#[test]
fn single_frame_and_no_vsync_are_options() {
    let options = Options { two_frames: false, vsync: false, ..Options::default() };
    let (device, witness) = Script::ps3fb().open_with(options);
    let mut device = device.unwrap();
    for seed in 0..2 {
        show(&mut device, seed);
        witness.assert_shows(device.geometry(), 5120, 0, seed);
    }
    let text = device.describe();
    assert!(text.contains("1 frame ") && text.contains("no vsync"), "{text}");
    drop(device);
    assert_eq!(witness.calls(), [Screeninfo, On, Fsel(0), Fsel(0), Fsel(0), Off]);

    let (device, witness) = Script::panning().open_with(options);
    let mut device = device.unwrap();
    show(&mut device, 1);
    witness.assert_shows(device.geometry(), 404, 0, 1);
    drop(device);
    assert_eq!(witness.calls(), []);
}

#[test]
fn released_screen_is_restored_once_and_taken_over_again() {
    let (device, witness) = Script::ps3fb().open(None, None);
    let mut device = device.unwrap();
    show(&mut device, 0);
    witness.calls();
    assert!(!device.display.come_back().unwrap());
    device.display.leave();
    device.display.leave();
    assert_eq!(witness.calls(), [Off]);
    assert!(device.display.come_back().unwrap());
    assert!(!device.display.come_back().unwrap());
    assert_eq!(witness.calls(), [On]);
    show(&mut device, 1);
    assert_eq!(witness.calls(), [Vsync, Fsel(1)]);
    device.display.leave();
    drop(device);
    assert_eq!(witness.calls(), [Off]);
}

#[test]
fn inspection_describes_driver_without_changes() {
    let mut script = Script::ps3fb();
    script.mode = 131;
    let expected =
        "/dev/fb0, driver ps3fb, 1280x720, stride 5120 bytes, memory for 2 frames, video mode 131";
    assert_eq!(script.inspect(), (expected.to_owned(), vec![Getmode]));
    let other = Script::panning().failing([(Getmode, libc::ENOTTY)]);
    let expected = "/dev/fb0, driver simple, 101x57, stride 404 bytes, memory for 2 frames";
    assert_eq!(other.inspect(), (expected.to_owned(), vec![Getmode]));
}
