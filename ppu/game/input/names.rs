//! The names of keys, buttons and axes, and sets of the held ones.

use std::marker::PhantomData;

use serde::{Deserialize, Serialize};

/// A key or button: something with a number below 128 that is pressed, held and released.
pub(super) trait Name: Copy {
    fn number(self) -> u32;
}

macro_rules! names {
    (
        $( #[doc = $doc:literal] )+
        $name:ident {
            $( #[doc = $variant_doc:literal] $variant:ident, )*
        }
    ) => {
        $( #[doc = $doc] )+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum $name {
            $( #[doc = $variant_doc] $variant, )*
        }

        impl $name {
            /// All of them.
            pub const ALL: &[Self] = &[ $( Self::$variant, )* ];
        }

        impl Name for $name {
            fn number(self) -> u32 {
                self as u32
            }
        }

        const _: () = assert!($name::ALL.len() <= u128::BITS as usize);
    };
}

names! {
    /// A key, named by its place on a US keyboard, whatever is printed on it.
    Key {
        /// A.
        A,
        /// B.
        B,
        /// C.
        C,
        /// D.
        D,
        /// E.
        E,
        /// F.
        F,
        /// G.
        G,
        /// H.
        H,
        /// I.
        I,
        /// J.
        J,
        /// K.
        K,
        /// L.
        L,
        /// M.
        M,
        /// N.
        N,
        /// O.
        O,
        /// P.
        P,
        /// Q.
        Q,
        /// R.
        R,
        /// S.
        S,
        /// T.
        T,
        /// U.
        U,
        /// V.
        V,
        /// W.
        W,
        /// X.
        X,
        /// Y.
        Y,
        /// Z.
        Z,
        /// 0.
        Digit0,
        /// 1.
        Digit1,
        /// 2.
        Digit2,
        /// 3.
        Digit3,
        /// 4.
        Digit4,
        /// 5.
        Digit5,
        /// 6.
        Digit6,
        /// 7.
        Digit7,
        /// 8.
        Digit8,
        /// 9.
        Digit9,
        /// The key between Tab and Escape.
        Backquote,
        /// Minus.
        Minus,
        /// Equals.
        Equal,
        /// The left bracket.
        BracketLeft,
        /// The right bracket.
        BracketRight,
        /// The backslash.
        Backslash,
        /// The semicolon.
        Semicolon,
        /// The quote.
        Quote,
        /// The comma.
        Comma,
        /// The period.
        Period,
        /// The slash.
        Slash,
        /// The space bar.
        Space,
        /// Enter, on the number pad too.
        Enter,
        /// Tab.
        Tab,
        /// Backspace.
        Backspace,
        /// Escape.
        Escape,
        /// The arrow up.
        Up,
        /// The arrow down.
        Down,
        /// The arrow to the left.
        Left,
        /// The arrow to the right.
        Right,
        /// Insert.
        Insert,
        /// Delete.
        Delete,
        /// Home.
        Home,
        /// End.
        End,
        /// Page up.
        PageUp,
        /// Page down.
        PageDown,
        /// Either shift key.
        Shift,
        /// Either control key.
        Control,
        /// Either alt key.
        Alt,
        /// F1.
        F1,
        /// F2.
        F2,
        /// F3.
        F3,
        /// F4.
        F4,
        /// F5.
        F5,
        /// F6.
        F6,
        /// F7.
        F7,
        /// F8.
        F8,
        /// F9.
        F9,
        /// F10.
        F10,
        /// F11.
        F11,
        /// F12.
        F12,
    }
}

names! {
    /// A button of the mouse.
    MouseButton {
        /// The left one.
        Left,
        /// The right one.
        Right,
        /// The middle one, which often is the wheel.
        Middle,
        /// The thumb button for going back.
        Back,
        /// The thumb button for going forward.
        Forward,
    }
}

names! {
    /// A button of a pad, with the SIXAXIS' names. On other pads it is the button in the same
    /// place.
    Button {
        /// The lowest of the four face buttons.
        Cross,
        /// The right face button.
        Circle,
        /// The left face button.
        Square,
        /// The upper face button.
        Triangle,
        /// The upper left shoulder button.
        L1,
        /// The upper right shoulder button.
        R1,
        /// The lower left shoulder button.
        L2,
        /// The lower right shoulder button.
        R2,
        /// The left stick, pressed.
        L3,
        /// The right stick, pressed.
        R3,
        /// Select, or share.
        Select,
        /// Start, or options.
        Start,
        /// The button with the maker's logo.
        Ps,
        /// Up on the directional pad.
        Up,
        /// Down on the directional pad.
        Down,
        /// Left on the directional pad.
        Left,
        /// Right on the directional pad.
        Right,
    }
}

names! {
    /// An axis of a pad.
    Axis {
        /// The left stick: -1 at the left, 1 at the right.
        LeftX,
        /// The left stick: -1 away from the player, 1 towards the player.
        LeftY,
        /// The right stick: -1 at the left, 1 at the right.
        RightX,
        /// The right stick: -1 away from the player, 1 towards the player.
        RightY,
        /// How far L2 is pressed, 0 to 1.
        L2,
        /// How far R2 is pressed, 0 to 1.
        R2,
    }
}

/// Which keys or buttons are down, and which went down or up in this frame; a bit for each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Switches<N> {
    down: u128,
    pressed: u128,
    released: u128,
    names: PhantomData<N>,
}

impl<N> Default for Switches<N> {
    fn default() -> Self {
        Self { down: 0, pressed: 0, released: 0, names: PhantomData }
    }
}

impl<N: Name> Switches<N> {
    pub fn begin_frame(&mut self) {
        self.pressed = 0;
        self.released = 0;
    }

    pub fn set(&mut self, name: N, down: bool) {
        let bit = 1 << name.number();
        if down && self.down & bit == 0 {
            self.down |= bit;
            self.pressed |= bit;
        } else if !down && self.down & bit != 0 {
            self.down &= !bit;
            self.released |= bit;
        }
    }

    pub fn release_all(&mut self) {
        self.released |= self.down;
        self.down = 0;
    }

    /// Whether it is down, or was pressed and released within this frame: otherwise a short press
    /// would never count as held.
    pub fn held(&self, name: N) -> bool {
        (self.down | self.pressed) >> name.number() & 1 == 1
    }

    pub fn pressed(&self, name: N) -> bool {
        self.pressed >> name.number() & 1 == 1
    }

    pub fn released(&self, name: N) -> bool {
        self.released >> name.number() & 1 == 1
    }
}
