//! The command `polhode`.

fn main() {}
