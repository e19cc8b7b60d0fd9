//! Which frame a label means.

use crate::notation::ast::FrameLabel;

/// The frame that a derivative is taken in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Frame {
    /// Of fixed orientation.
    Space,
    /// The axes used, which turn.
    Moving,
}

/// The frame of a label; `None` where the label says nothing that is known.
pub(super) fn frame(label: &FrameLabel) -> Option<Frame> {
    let text: String = label.text.chars().filter(|c| c.is_alphanumeric()).collect();
    let lower = text.to_lowercase();
    let lower = lower
        .strip_prefix("in")
        .filter(|rest| rest.len() < 3 && !rest.is_empty())
        .unwrap_or(&lower);
    if label.text.trim() == "'" {
        return Some(Frame::Moving);
    }
    match text.as_str() {
        "XYZ" | "XY" | "N" | "A" | "E" | "OXYZ" | "S0" | "R0" | "F" | "I" | "S" | "R" => {
            return Some(Frame::Space);
        }
        "xyz" | "xy" | "B" | "b" | "Oxyz" | "Gxyz" | "M" | "R1" | "S1" => {
            return Some(Frame::Moving);
        }
        _ => {}
    }
    match lower {
        "space" | "inertial" | "fixed" | "f" | "n" | "i" | "in" | "lab" | "abs" | "absolute"
        | "world" | "w" | "inert" | "ground" | "0" | "s" | "fix" | "s0" | "r0" => {
            Some(Frame::Space)
        }
        "body" | "rot" | "rotating" | "b" | "m" | "moving" | "rel" | "relative" | "bodyfixed"
        | "r" | "rotate" | "turning" | "s1" | "r1" | "1" | "bodyaxes" | "rotatingframe"
        | "local" => Some(Frame::Moving),
        _ => None,
    }
}
