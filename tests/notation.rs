//! The reader: what each spelling is read as, in every kind of file, and what becomes of text that was made to hurt.
#![cfg(feature = "verify")]

mod notation {
    mod alphabets;
    mod derivatives;
    mod files;
    mod habits;
    mod hostile;
    mod lines;
    #[cfg(feature = "cli")]
    mod manual;
    mod marks;
    mod mutations;
    mod outline;
    mod places;
    mod plain;
    mod print;
    mod products;
    mod rarer;
    mod recent;
    mod repeated;
    mod vectors;
}
