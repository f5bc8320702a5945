//! The kernel's interface for framebuffers and consoles: structures, request numbers, constants.
//!
//! The names are the kernel's, from linux/fb.h, linux/kd.h and asm/ps3fb.h. This file makes no
//! calls.

use std::mem::offset_of;

/// The encoding of direction, size, type and number in a machine's requests (asm/ioctl.h).
pub(super) struct Encoding {
    none: u32,
    write: u32,
    direction_shift: u32,
}

impl Encoding {
    /// The encoding of most machines: two direction bits above fourteen size bits.
    pub(super) const GENERIC: Encoding = Encoding { none: 0, write: 1, direction_shift: 30 };
    /// The encoding of PowerPC, MIPS and SPARC: three direction bits above thirteen size bits.
    pub(super) const POWERPC: Encoding = Encoding { none: 1, write: 4, direction_shift: 29 };
    /// The encoding of the machine that this is compiled for.
    pub(super) const HOST: Encoding = if cfg!(any(
        target_arch = "powerpc",
        target_arch = "powerpc64",
        target_arch = "mips",
        target_arch = "mips64",
        target_arch = "sparc",
        target_arch = "sparc64",
    )) {
        Encoding::POWERPC
    } else {
        Encoding::GENERIC
    };
    /// The only direction with the same number on all machines.
    const READ: u32 = 2;

    const fn request(&self, direction: u32, kind: u8, number: u8, size: usize) -> u32 {
        direction << self.direction_shift | (size as u32) << 16 | (kind as u32) << 8 | number as u32
    }

    pub(super) const fn fbio_waitforvsync(&self) -> u32 {
        self.request(self.write, b'F', 0x20, size_of::<u32>())
    }

    pub(super) const fn ps3fb_ioctl_setmode(&self) -> u32 {
        self.request(self.write, b'r', 1, size_of::<u32>())
    }

    pub(super) const fn ps3fb_ioctl_getmode(&self) -> u32 {
        self.request(Self::READ, b'r', 2, size_of::<u32>())
    }

    /// Encoded with the size of an int, although the kernel writes a [`Ps3fbIoctlRes`].
    pub(super) const fn ps3fb_ioctl_screeninfo(&self) -> u32 {
        self.request(Self::READ, b'r', 3, size_of::<u32>())
    }

    pub(super) const fn ps3fb_ioctl_on(&self) -> u32 {
        self.request(self.none, b'r', 4, 0)
    }

    pub(super) const fn ps3fb_ioctl_off(&self) -> u32 {
        self.request(self.none, b'r', 5, 0)
    }

    pub(super) const fn ps3fb_ioctl_fsel(&self) -> u32 {
        self.request(self.write, b'r', 6, size_of::<u32>())
    }
}

// These requests are older than the encoding. They have the same numbers on every machine.
pub(super) const FBIOGET_VSCREENINFO: u32 = 0x4600;
pub(super) const FBIOGET_FSCREENINFO: u32 = 0x4602;
pub(super) const FBIOPAN_DISPLAY: u32 = 0x4606;
pub(super) const KDSETMODE: u32 = 0x4B3A;
pub(super) const KDGETMODE: u32 = 0x4B3B;
pub(super) const VT_GETMODE: u32 = 0x5601;
pub(super) const VT_SETMODE: u32 = 0x5602;
pub(super) const VT_GETSTATE: u32 = 0x5603;
pub(super) const VT_RELDISP: u32 = 0x5605;

/// The console mode in which the kernel draws text.
pub(super) const KD_TEXT: i32 = 0;
/// The console mode in which a program draws.
pub(super) const KD_GRAPHICS: i32 = 1;

/// The kernel sends signals to the program before its terminal leaves the screen, and after it
/// came back.
pub(super) const VT_PROCESS: i8 = 1;
/// VT_RELDISP: another terminal may have the screen.
pub(super) const VT_RELEASED: i32 = 1;
/// VT_RELDISP: the screen is taken back.
pub(super) const VT_ACKACQ: i32 = 2;

pub(super) const FB_TYPE_PACKED_PIXELS: u32 = 0;
pub(super) const FB_VISUAL_TRUECOLOR: u32 = 2;
/// Requests that a change takes effect at the next vertical blank.
pub(super) const FB_ACTIVATE_VBL: u32 = 16;

/// The position of a channel in a native pixel, in bits from the least significant.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FbBitfield {
    pub(super) offset: u32,
    pub(super) length: u32,
    pub(super) msb_right: u32,
}

/// The settings of a screen that a program may change.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FbVarScreeninfo {
    pub(super) xres: u32,
    pub(super) yres: u32,
    pub(super) xres_virtual: u32,
    pub(super) yres_virtual: u32,
    pub(super) xoffset: u32,
    pub(super) yoffset: u32,
    pub(super) bits_per_pixel: u32,
    pub(super) grayscale: u32,
    pub(super) red: FbBitfield,
    pub(super) green: FbBitfield,
    pub(super) blue: FbBitfield,
    pub(super) transp: FbBitfield,
    pub(super) nonstd: u32,
    pub(super) activate: u32,
    pub(super) height: u32,
    pub(super) width: u32,
    pub(super) accel_flags: u32,
    pub(super) pixclock: u32,
    pub(super) left_margin: u32,
    pub(super) right_margin: u32,
    pub(super) upper_margin: u32,
    pub(super) lower_margin: u32,
    pub(super) hsync_len: u32,
    pub(super) vsync_len: u32,
    pub(super) sync: u32,
    pub(super) vmode: u32,
    pub(super) rotate: u32,
    pub(super) colorspace: u32,
    pub(super) reserved: [u32; 4],
}

/// The properties of a screen that its mode determines.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FbFixScreeninfo {
    pub(super) id: [u8; 16],
    pub(super) smem_start: libc::c_ulong,
    pub(super) smem_len: u32,
    pub(super) kind: u32,
    pub(super) type_aux: u32,
    pub(super) visual: u32,
    pub(super) xpanstep: u16,
    pub(super) ypanstep: u16,
    pub(super) ywrapstep: u16,
    pub(super) line_length: u32,
    pub(super) mmio_start: libc::c_ulong,
    pub(super) mmio_len: u32,
    pub(super) accel: u32,
    pub(super) capabilities: u16,
    pub(super) reserved: [u16; 2],
}

/// The result of PS3FB_IOCTL_SCREENINFO. Only `num_frames` is useful. The other fields describe
/// the raster of the driver's first version.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ps3fbIoctlRes {
    pub(super) xres: u32,
    pub(super) yres: u32,
    pub(super) xoff: u32,
    pub(super) yoff: u32,
    pub(super) num_frames: u32,
}

/// The result of VT_GETSTATE.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct VtStat {
    /// The number of the virtual terminal that is on the screen.
    pub(super) active: u16,
    pub(super) signal: u16,
    /// The open terminals, one bit for each.
    pub(super) state: u16,
}

/// How the kernel switches away from a virtual terminal: VT_GETMODE and VT_SETMODE.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct VtMode {
    pub(super) mode: i8,
    pub(super) waitv: i8,
    /// The signal that requests the screen.
    pub(super) relsig: i16,
    /// The signal that returns the screen.
    pub(super) acqsig: i16,
    pub(super) frsig: i16,
}

const _: () = assert!(size_of::<VtStat>() == 6 && size_of::<VtMode>() == 8);

// The offsets were measured with a powerpc64 compiler. Those of 32-bit fields hold on every
// machine.
const _: () = {
    assert!(size_of::<FbBitfield>() == 12);
    assert!(size_of::<FbVarScreeninfo>() == 160);
    assert!(offset_of!(FbVarScreeninfo, bits_per_pixel) == 24);
    assert!(offset_of!(FbVarScreeninfo, red) == 32);
    assert!(offset_of!(FbVarScreeninfo, transp) == 68);
    assert!(offset_of!(FbVarScreeninfo, activate) == 84);
    assert!(offset_of!(FbVarScreeninfo, pixclock) == 100);
    assert!(offset_of!(FbVarScreeninfo, vmode) == 132);
    assert!(size_of::<Ps3fbIoctlRes>() == 20);
};

#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<FbFixScreeninfo>() == 80);
    assert!(offset_of!(FbFixScreeninfo, smem_start) == 16);
    assert!(offset_of!(FbFixScreeninfo, smem_len) == 24);
    assert!(offset_of!(FbFixScreeninfo, kind) == 28);
    assert!(offset_of!(FbFixScreeninfo, visual) == 36);
    assert!(offset_of!(FbFixScreeninfo, xpanstep) == 40);
    assert!(offset_of!(FbFixScreeninfo, line_length) == 48);
    assert!(offset_of!(FbFixScreeninfo, mmio_start) == 56);
    assert!(offset_of!(FbFixScreeninfo, accel) == 68);
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powerpc_requests_equal_kernel_encoding() {
        let ppc = Encoding::POWERPC;
        assert_eq!(ppc.fbio_waitforvsync(), 0x8004_4620);
        assert_eq!(ppc.ps3fb_ioctl_setmode(), 0x8004_7201);
        assert_eq!(ppc.ps3fb_ioctl_getmode(), 0x4004_7202);
        assert_eq!(ppc.ps3fb_ioctl_screeninfo(), 0x4004_7203);
        assert_eq!(ppc.ps3fb_ioctl_on(), 0x2000_7204);
        assert_eq!(ppc.ps3fb_ioctl_off(), 0x2000_7205);
        assert_eq!(ppc.ps3fb_ioctl_fsel(), 0x8004_7206);
    }

    #[test]
    fn requests_elsewhere_follow_the_generic_encoding() {
        let generic = Encoding::GENERIC;
        assert_eq!(generic.fbio_waitforvsync(), 0x4004_4620);
        assert_eq!(generic.ps3fb_ioctl_setmode(), 0x4004_7201);
        assert_eq!(generic.ps3fb_ioctl_getmode(), 0x8004_7202);
        assert_eq!(generic.ps3fb_ioctl_screeninfo(), 0x8004_7203);
        assert_eq!(generic.ps3fb_ioctl_on(), 0x0000_7204);
        assert_eq!(generic.ps3fb_ioctl_off(), 0x0000_7205);
        assert_eq!(generic.ps3fb_ioctl_fsel(), 0x4004_7206);
    }

    #[test]
    fn host_encoding_equals_libc() {
        // A request that writes an int, which libc defines for every machine.
        let host = Encoding::HOST;
        assert_eq!(
            host.request(host.write, b'T', 202, size_of::<u32>()) as libc::Ioctl,
            libc::TUNSETIFF
        );
    }
}
