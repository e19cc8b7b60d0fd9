//! Submissions of twenty lines of which no two are alike: orders of terms and of factors, ways to write vectors and rates,
//! steps on the way, and up to three mistakes, some of them carried on.

/// A random sequence (splitmix64).
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % n as u64) as usize
    }

    fn shuffled<T>(&mut self, mut items: Vec<T>) -> Vec<T> {
        for at in (1..items.len()).rev() {
            items.swap(at, self.below(at + 1));
        }
        items
    }
}

/// A number and the letters that it is multiplied by.
type Term = (i64, Vec<String>);

/// Terms as `I_xx w_x - I_xz w_z`, with `w` for ω and a dash behind the letter of a rate.
fn terms(text: &str) -> Vec<Term> {
    let mut sign = 1;
    let mut terms: Vec<Term> = vec![];
    let mut begins = true;
    for word in text.split_whitespace() {
        match word {
            "+" => (sign, begins) = (1, true),
            "-" => (sign, begins) = (-1, true),
            letter if begins => {
                terms.push((sign, vec![letter.to_owned()]));
                begins = false;
            }
            letter => {
                if let Some((_, letters)) = terms.last_mut() {
                    letters.push(letter.to_owned());
                }
            }
        }
    }
    terms
}

/// One student at work.
struct Student {
    random: Random,
    vector: &'static str,
    rate: usize,
    display: [&'static str; 2],
    /// Terms of the angular momentum whose sign is wrong, wherever they come.
    wrong: Vec<usize>,
    text: String,
}

/// The components of the angular momentum, of which the terms are numbered from left to right.
const MOMENTUM: [&str; 3] = ["I_xx w_x - I_xz w_z", "I_yy w_y", "I_zz w_z - I_xz w_x"];

const AXES: [char; 3] = ['x', 'y', 'z'];

impl Student {
    fn new(number: usize) -> Self {
        let mut random = Random(number as u64);
        let mistakes = [0, 0, 1, 1, 2][random.below(5)];
        Self {
            vector: [r"\vec", r"\mathbf", r"\boldsymbol"][random.below(3)],
            rate: random.below(3),
            display: [["$$", "$$\n"], ["\n$$\n", "\n$$\n\n"], ["\\[", "\\]\n"]][random.below(3)],
            wrong: (0..mistakes).map(|_| random.below(5)).collect(),
            random,
            text: String::new(),
        }
    }

    fn line(&mut self, formula: &str) {
        let word = ["", "So ", "Then ", "Hence ", "With that "][self.random.below(5)];
        let [open, close] = self.display;
        self.text.push_str(&format!("{word}{open}{formula}{close}"));
    }

    fn letter(&self, name: &str) -> String {
        let (base, is_rate) = match name.strip_suffix('\'') {
            Some(base) => (base, true),
            None => (name, false),
        };
        let (head, index) = base.split_once('_').unwrap_or((base, ""));
        let head = head.replace('w', r"\omega");
        let index = match index.len() {
            0 => String::new(),
            1 => format!("_{index}"),
            _ => format!("_{{{index}}}"),
        };
        match (is_rate, self.rate) {
            (false, _) => head + &index,
            (true, 0) => format!("\\dot {head}{index}"),
            (true, 1) => format!("\\dot{{{head}}}{index}"),
            (true, _) => format!("\\frac{{d{head}{index}}}{{dt}}"),
        }
    }

    /// A sum in an order of its own, its products too.
    fn sum(&mut self, terms: Vec<Term>) -> String {
        let mut text = String::new();
        for (number, letters) in self.random.shuffled(terms) {
            let sign = match (number < 0, text.is_empty()) {
                (true, _) => "-",
                (false, true) => "",
                (false, false) => "+",
            };
            let size = match number.abs() {
                1 => String::new(),
                size => size.to_string(),
            };
            let letters = self.random.shuffled(letters);
            let letters: Vec<String> = letters.iter().map(|name| self.letter(name)).collect();
            text.push_str(&format!("{sign} {size}{}", letters.join(" ")));
        }
        text
    }

    /// A component of the angular momentum as the student believes it to be.
    fn momentum(&self, axis: usize) -> Vec<Term> {
        let first: usize = (0..axis).map(|other| terms(MOMENTUM[other]).len()).sum();
        let own = terms(MOMENTUM[axis]).into_iter().enumerate();
        let believed =
            own.map(
                |(at, (number, letters))| match self.wrong.contains(&(first + at)) {
                    true => (-number, letters),
                    false => (number, letters),
                },
            );
        believed.collect()
    }

    fn equation(&mut self, left: Vec<Term>, right: Vec<Term>) {
        let (left, right) = (self.sum(left), self.sum(right));
        self.line(&format!("{left} = {right}"));
    }

    /// The law on the axis behind two others: M_z of x and y.
    fn component(&mut self, axis: usize) {
        let [x, y] = [1, 2].map(|step| AXES[(axis + step) % 3]);
        let z = AXES[axis];
        let right = terms(&format!("L_{z}' + w_{x} L_{y} - w_{y} L_{x}"));
        self.equation(terms(&format!("M_{z}")), right);
    }

    /// The momentum, or its rate, multiplied by something.
    fn multiple(&mut self, axis: usize, is_rate: bool, number: i64, by: &str) {
        let left = terms(&format!("L_{}", AXES[axis]));
        let sides = [left, self.momentum(axis)].map(|side| match is_rate {
            true => times(rates(side), number, by),
            false => times(side, number, by),
        });
        let [left, right] = sides;
        self.equation(left, right);
    }

    fn step(&mut self) {
        let axis = self.random.below(3);
        let other = format!("w_{}", AXES[self.random.below(3)]);
        let number = 1 + self.random.below(4) as i64;
        match self.random.below(4) {
            0 => self.multiple(axis, false, number, &other),
            1 => self.multiple(axis, false, number + 1, ""),
            2 => self.multiple(axis, true, number, &other),
            _ => {
                let [x, y] = [1, 2].map(|step| AXES[(axis + step) % 3]);
                let z = AXES[axis];
                let left = terms(&format!("M_{z} - L_{z}'"));
                self.equation(left, terms(&format!("w_{x} L_{y} - w_{y} L_{x}")));
            }
        }
    }

    /// The first component with the momentum put in.
    fn answer(&mut self, rate: Vec<Term>) {
        let mut all = rate;
        all.extend(times(self.momentum(2), 1, "w_y"));
        all.extend(times(self.momentum(1), -1, "w_z"));
        self.equation(terms("M_x"), all);
    }
}

/// Terms multiplied by a number and a letter.
fn times(mut terms: Vec<Term>, number: i64, by: &str) -> Vec<Term> {
    for (own, letters) in &mut terms {
        *own *= number;
        letters.extend((!by.is_empty()).then(|| by.to_owned()));
    }
    terms
}

/// The rates of terms in which nothing but L and ω changes.
fn rates(mut terms: Vec<Term>) -> Vec<Term> {
    let letters = terms.iter_mut().flat_map(|(_, letters)| letters);
    letters
        .filter(|name| name.starts_with(['L', 'w']))
        .for_each(|name| name.push('\''));
    terms
}

/// The work of one student, the same for the same number.
pub(crate) fn submission(number: usize) -> String {
    let mut own = Student::new(number);
    let vector = own.vector;
    own.line(&format!(
        r"{vector} M = (\dot{{{vector} L}})_{{xyz}} + {vector}\omega\times {vector} L"
    ));
    let momentum_first = own.random.below(2) == 0;
    for at in 0..2 {
        match (at == 0) == momentum_first {
            true => (0..3).for_each(|axis| own.multiple(axis, false, 1, "")),
            false => (0..3).for_each(|axis| own.component(axis)),
        }
    }
    (0..2).for_each(|axis| own.multiple(axis, true, 1, ""));
    own.answer(terms("L_x'"));
    (0..9).for_each(|_| own.step());
    let rate = rates(own.momentum(0));
    own.answer(rate);
    own.text
}
