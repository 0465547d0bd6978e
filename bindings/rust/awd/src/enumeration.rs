// SPDX-License-Identifier: Apache-2.0
//! Enums of C, which are numbers there: a newer library may know more of them than this crate.

macro_rules! enumeration {
    ($( #[$meta:meta] )* $name:ident {
        $( $( #[$each:meta] )* $variant:ident = $value:ident, )*
    }) => {
        $( #[$meta] )*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $name {
            $( $( #[$each] )* $variant, )*
            /// A value that this version of the crate does not know.
            Other(i32),
        }

        impl $name {
            /// The value in C.
            pub fn raw(self) -> i32 {
                match self {
                    $( $name::$variant => awd_sys::$value, )*
                    $name::Other(value) => value,
                }
            }

            /// The one of that value in C.
            pub fn from_raw(value: i32) -> Self {
                match value {
                    $( awd_sys::$value => $name::$variant, )*
                    value => $name::Other(value),
                }
            }
        }
    };
}
