//! Tests of the device's logic with scripted drivers: the calls in their order, and the pixels.

mod options;
mod script;

use super::super::ioctl::FbBitfield;
use super::super::pattern;
use super::*;
use script::Call::{Fsel, Off, On, Pan, Screeninfo, Vsync};
use script::{MIB, PATH, Script};

fn show(device: &mut Device, seed: u32) {
    pattern::paint(device.target(), seed);
    device.present().unwrap();
}

#[test]
fn ps3fb_alternates_two_frames_in_its_own_memory() {
    let (device, witness) = Script::ps3fb().open(None, None);
    let mut device = device.unwrap();
    assert_eq!(device.mode(), Mode::Direct);
    assert_eq!(witness.calls(), [Screeninfo, On, Fsel(1)]);
    for (seed, frame) in [(0, 0), (1, 1), (2, 0)] {
        show(&mut device, seed);
        assert_eq!(witness.calls(), [Vsync, Fsel(frame)]);
        witness.assert_shows(device.geometry(), 5120, frame as usize * 5120 * 720, seed);
    }
    witness.assert_shows(device.geometry(), 5120, 5120 * 720, 1);
    let text = device.describe();
    for part in [PATH, "ps3fb", "1280x720", "5120", "2 frames", "in its memory"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    drop(device);
    assert_eq!(witness.calls(), [Off]);
}

#[test]
fn contents_are_kept_in_private_memory_and_on_own_console() {
    // The script has no console, so the device's memory may not keep its contents.
    let (device, _) = Script::ps3fb().open(None, Some(Mode::Direct));
    assert!(!device.unwrap().keeps_contents());
    let (device, _) = Script::ps3fb().open(None, Some(Mode::Shadow));
    assert!(device.unwrap().keeps_contents());
}

#[test]
fn ps3fb_with_borders_keeps_its_line_length() {
    let (device, witness) =
        Script::new("ps3fb", 1124, 644, 4544, 9 * MIB - 0x1_0000).open(None, None);
    let mut device = device.unwrap();
    assert_eq!((device.mode(), device.target().stride), (Mode::Direct, 4544));
    show(&mut device, 1);
    show(&mut device, 2);
    witness.assert_shows(device.geometry(), 4544, 4544 * 644, 2);
}

#[test]
fn ps3fb_with_one_frame_selects_it_alone() {
    // Two 1080p frames don't fit the default memory, whatever the driver reports.
    let (device, witness) =
        Script::new("ps3fb", 1920, 1080, 7680, 9 * MIB - 0x1_0000).open(None, None);
    let mut device = device.unwrap();
    assert!(device.describe().contains("vsync if the driver can"));
    show(&mut device, 0);
    assert!(device.describe().contains(", vsync, "));
    show(&mut device, 1);
    drop(device);
    assert_eq!(witness.calls(), [Screeninfo, On, Fsel(0), Vsync, Fsel(0), Vsync, Fsel(0), Off]);

    let mut script = Script::ps3fb();
    script.num_frames = 1;
    let (device, witness) = script.open(None, None);
    drop(device.unwrap());
    assert_eq!(witness.calls(), [Screeninfo, On, Fsel(0), Off]);
}

#[test]
fn ps3fb_with_one_frame_less_uses_one() {
    let (device, witness) = Script::ps3fb().failing([(Fsel(1), libc::EINVAL)]).open(None, None);
    show(&mut device.unwrap(), 0);
    assert_eq!(witness.calls(), [Screeninfo, On, Fsel(1), Fsel(0), Vsync, Fsel(0), Off]);
}

#[test]
fn ps3fb_without_selection_copies_to_the_visible_frame() {
    let selects = [(Fsel(0), libc::ENOTTY), (Fsel(1), libc::ENOTTY)];
    let (device, witness) = Script::ps3fb().failing(selects).open(None, None);
    let mut device = device.unwrap();
    assert_eq!(device.mode(), Mode::Shadow);
    assert_eq!(witness.calls(), [Screeninfo, On, Fsel(1), Fsel(0), Off]);
    show(&mut device, 5);
    witness.assert_shows(device.geometry(), 5120, 0, 5);
    drop(device);
    assert_eq!(witness.calls(), [Vsync]);
}

#[test]
fn ps3fb_over_video_memory_is_one_frame_to_copy_to() {
    let (device, witness) = Script::new("ps3fb", 1280, 720, 5120, 32 * MIB).open(None, None);
    let mut device = device.unwrap();
    assert_eq!(device.mode(), Mode::Shadow);
    show(&mut device, 5);
    show(&mut device, 6);
    witness.assert_shows(device.geometry(), 5120, 0, 6);
    drop(device);
    assert_eq!(witness.calls(), [Vsync, Vsync]);
}

#[test]
fn every_missing_call_is_tried_once() {
    for errno in [libc::ENOTTY, libc::ENOSYS, libc::EINVAL] {
        let missing = [(Screeninfo, errno), (Vsync, errno)];
        let (device, witness) = Script::ps3fb().failing(missing).open(None, None);
        let mut device = device.unwrap();
        for seed in 0..3 {
            show(&mut device, seed);
            witness.assert_shows(device.geometry(), 5120, 0, seed);
        }
        assert!(device.describe().contains("no vsync"));
        drop(device);
        assert_eq!(witness.calls(), [Screeninfo, Vsync]);

        let (device, witness) = Script::ps3fb().failing([(On, errno)]).open(None, None);
        drop(device.unwrap());
        assert_eq!(witness.calls(), [Screeninfo, On]);

        let missing = [(Pan(0, 57), errno), (Vsync, errno)];
        let (device, witness) = Script::panning().failing(missing).open(None, None);
        let mut device = device.unwrap();
        for seed in 0..3 {
            show(&mut device, seed);
            witness.assert_shows(device.geometry(), 404, 0, seed);
        }
        drop(device);
        assert_eq!(witness.calls(), [Pan(0, 57), Vsync]);
    }
}

#[test]
fn another_failure_is_an_error_that_names_the_call() {
    let (device, _) = Script::ps3fb().failing([(On, libc::EIO)]).open(None, None);
    let text = device.err().unwrap().to_string();
    assert!(text.contains(PATH) && text.contains("PS3FB_IOCTL_ON"), "{text}");

    let (device, witness) = Script::ps3fb().failing([(Fsel(0), libc::EIO)]).open(None, None);
    let mut device = device.unwrap();
    let text = device.present().unwrap_err().to_string();
    assert!(text.contains("PS3FB_IOCTL_FSEL"), "{text}");
    drop(device);
    assert_eq!(witness.calls().last(), Some(&Off));

    let (device, _) = Script::panning().failing([(Vsync, libc::ENODEV)]).open(None, None);
    assert!(device.unwrap().present().unwrap_err().to_string().contains("FBIO_WAITFORVSYNC"));
}

#[test]
fn missing_vertical_blank_does_not_stop_frames() {
    for errno in [libc::ETIMEDOUT, libc::EINTR] {
        let (device, witness) = Script::ps3fb().failing([(Vsync, errno)]).open(None, None);
        let mut device = device.unwrap();
        show(&mut device, 0);
        show(&mut device, 1);
        assert_eq!(witness.calls()[3..], [Vsync, Fsel(0), Vsync, Fsel(1)]);
    }
}

#[test]
fn panning_alternates_and_is_restored() {
    let mut script = Script::panning();
    script.var.yoffset = 3;
    let (device, witness) = script.open(None, None);
    let mut device = device.unwrap();
    // 404 bytes are not a multiple of 16, so SPUs write to the shadow's lines.
    assert_eq!(device.mode(), Mode::Shadow);
    assert_eq!(witness.calls(), [Pan(0, 57)]);
    for (seed, frame) in [(0, 0), (1, 1), (2, 0)] {
        show(&mut device, seed);
        assert_eq!(witness.calls(), [Pan(0, frame * 57), Vsync]);
        witness.assert_shows(device.geometry(), 404, frame as usize * 404 * 57, seed);
    }
    drop(device);
    assert_eq!(witness.calls(), [Pan(0, 3)]);
}

#[test]
fn first_shown_frame_is_black() {
    let (_device, witness) = Script::panning().open(None, None);
    assert_eq!(witness.bytes(0..404 * 57 * 2), vec![0; 404 * 57 * 2]);
}

#[test]
fn drivers_without_panning_show_one_frame() {
    let mut short = Script::panning();
    short.var.yres_virtual = 57 * 2 - 1;
    let mut fixed = Script::panning();
    fixed.fix.ypanstep = 0;
    let mut coarse = Script::panning();
    coarse.fix.ypanstep = 8;
    let mut small = Script::panning();
    small.fix.smem_len = 404 * 57 * 2 - 1;
    for script in [short, fixed, coarse, small] {
        let (device, witness) = script.open(None, None);
        show(&mut device.unwrap(), 0);
        assert_eq!(witness.calls(), [Vsync]);
    }
}

#[test]
fn panned_screen_is_written_at_visible_offset() {
    let geometry = Geometry { width: 31, height: 20 };
    let mut script = Script::new("other", 31, 20, 203, 203 * 30);
    (script.var.xres_virtual, script.var.yres_virtual) = (50, 30);
    (script.var.xoffset, script.var.yoffset) = (7, 9);
    // A framebuffer need not begin on a page, nor a line on a word.
    script.start = 3;
    let (device, witness) = script.open(Some(geometry), None);
    let mut device = device.unwrap();
    let offset = 9 * 203 + 7 * 4;
    for seed in 0..2 {
        show(&mut device, seed);
        witness.assert_shows(geometry, 203, offset, seed);
    }
    assert!(witness.bytes(0..offset).iter().all(|&byte| byte == 0xA5));
    for y in 0..20 {
        let end = offset + y * 203 + 31 * 4;
        let next = if y < 19 { offset + (y + 1) * 203 } else { 203 * 30 };
        assert!(witness.bytes(end..next).iter().all(|&byte| byte == 0xA5), "after row {y}");
    }
}

#[test]
fn direct_output_requires_dma() {
    // 101 pixels are written as 104, for which 416 bytes are just enough.
    let (device, witness) =
        Script::new("other", 101, 57, 416, 416 * 57).open(None, Some(Mode::Direct));
    let mut device = device.unwrap();
    assert_eq!(device.mode(), Mode::Direct);
    show(&mut device, 4);
    witness.assert_shows(device.geometry(), 416, 0, 4);

    let mut off_grid = Script::new("other", 100, 57, 416, 416 * 57);
    off_grid.start = 8;
    let mut aside = Script::new("other", 100, 57, 416, 416 * 57);
    aside.var.xoffset = 4;
    let mut askew = Script::new("other", 99, 57, 416, 416 * 57);
    askew.var.xoffset = 1;
    let cases = [
        (Script::new("other", 101, 57, 404, 404 * 57), "404"),
        (Script::new("other", 101, 57, 408, 408 * 57), "408"),
        (off_grid, "address"),
        (Script::new("other", 100, 57, 416, 416 * 57 - 16), "last line"),
        (aside, "last line"),
        (askew, "address"),
    ];
    for (script, part) in cases {
        let (device, _) = script.open(None, Some(Mode::Direct));
        match device.err().unwrap() {
            FramebufferError::NoDirect { why, .. } => assert!(why.contains(part), "{part}: {why}"),
            other => panic!("{part}: {other}"),
        }
    }
}

#[test]
fn ps3fb_copies_on_request() {
    let (device, witness) = Script::ps3fb().open(None, Some(Mode::Shadow));
    let mut device = device.unwrap();
    assert_eq!(device.mode(), Mode::Shadow);
    show(&mut device, 0);
    show(&mut device, 1);
    witness.assert_shows(device.geometry(), 5120, 5120 * 720, 1);
}

#[test]
fn size_other_than_device_size_is_refused() {
    let (device, witness) = Script::ps3fb().open(Some(Geometry { width: 640, height: 480 }), None);
    let text = device.err().unwrap().to_string();
    assert!(text.contains("640x480") && text.contains("1280x720"), "{text}");
    assert_eq!(witness.calls(), []);
    assert!(witness.bytes(0..5120).iter().all(|&byte| byte == 0xA5));
    assert!(Script::ps3fb().open(Some(Geometry { width: 1280, height: 720 }), None).0.is_ok());
}

#[test]
fn other_pixel_formats_are_refused_in_driver_terms() {
    let plain = || Script::new("vga16fb", 64, 48, 256, 256 * 48);
    let changed = |change: fn(&mut Script)| {
        let mut script = plain();
        change(&mut script);
        script
    };
    let cases = [
        (changed(|script| script.var.bits_per_pixel = 16), "16 bits"),
        (changed(|script| script.fix.visual = 3), "visual 3"),
        (changed(|script| script.fix.kind = 1), "type 1"),
        (changed(|script| script.var.grayscale = 1), "0x1"),
        (
            changed(|script| script.var.red = FbBitfield { offset: 20, length: 10, msb_right: 0 }),
            "20+10",
        ),
        (changed(|script| script.var.green.offset = 16), "16+8, 16+8"),
    ];
    for (script, part) in cases {
        let (device, witness) = script.open(None, None);
        let error = device.err().unwrap();
        assert!(matches!(error, FramebufferError::UnsupportedPixels { .. }), "{part}: {error}");
        let text = error.to_string();
        assert!(
            text.contains(part) && text.contains("vga16fb") && text.contains(PATH),
            "{part}: {text}"
        );
        assert_eq!(witness.calls(), []);
    }
}

#[test]
fn contradictory_numbers_are_refused() {
    let plain = || Script::new("odd", 64, 48, 256, 256 * 48);
    assert!(plain().open(None, None).0.is_ok());
    let mut offset = plain();
    (offset.var.xoffset, offset.var.yoffset) = (u32::MAX, u32::MAX);
    // Products of the driver's numbers must not wrap around to offsets within the memory.
    let mut far = Script::new("odd", 64, 48, u32::MAX, 256 * 48);
    far.var.yoffset = u32::MAX;
    let mut tall = Script::new("odd", 64, 48, u32::MAX, 256 * 48);
    tall.var.yres_virtual = u32::MAX;
    let mut beside = plain();
    beside.var.xoffset = 1;
    let mut empty = plain();
    empty.var.xres = 0;
    let cases = [
        Script::new("odd", 64, 48, 255, 256 * 48),
        Script::new("odd", 64, 48, 0, 256 * 48),
        Script::new("odd", 64, 48, 256, 256 * 48 - 1),
        Script::new("odd", 64, 48, u32::MAX, 256 * 48),
        offset,
        far,
        tall,
        beside,
        empty,
    ];
    for script in cases {
        let error = script.open(None, None).0.err().unwrap();
        assert!(matches!(error, FramebufferError::BadSurface { .. }), "{error}");
        assert!(error.to_string().contains("driver odd"), "{error}");
    }
}
