//! Numbers of a scene: fixed, or drawn for each member of a group.

/// A number, or a distribution of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// The same for all.
    Fixed(f64),
    /// Evenly between the two.
    Uniform {
        /// The least.
        from: f64,
        /// The largest.
        to: f64,
    },
    /// Gaussian.
    Normal {
        /// The mean.
        mean: f64,
        /// The standard deviation.
        deviation: f64,
    },
}

impl Quantity {
    /// The number for one member.
    pub fn draw(&self, draw: &mut Draw) -> f64 {
        match *self {
            Self::Fixed(value) => value,
            // Weighted, as the difference of the ends may overflow.
            Self::Uniform { from, to } => {
                let part = draw.unit();
                from * (1.0 - part) + to * part
            }
            Self::Normal { mean, deviation } => mean + deviation * draw.normal(),
        }
    }

    /// Whether every member has the same number.
    pub fn is_fixed(&self) -> bool {
        matches!(self, Self::Fixed(_))
    }
}

/// The random numbers of one member: SplitMix64 (Steele, Lea, Flood, *Fast splittable pseudorandom number generators*,
/// OOPSLA 2014), which starts anywhere at no cost, so that member 70 000 does not wait for those before it.
#[derive(Clone, Debug)]
pub struct Draw(u64);

impl Draw {
    /// The numbers of a member, by the seed of its group.
    pub fn new(seed: u64, member: u64) -> Self {
        // Mixed twice, so that neighbouring seeds and members share no sequence.
        let mut of_seed = Self(seed);
        let mut of_member = Self(of_seed.next() ^ member);
        Self(of_member.next())
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly in [0, 1), in steps of 2⁻⁵³.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 * (0.5 * f64::EPSILON)
    }

    /// Of mean 0 and deviation 1 (Box and Muller 1958).
    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.unit()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.unit()).cos()
    }
}
