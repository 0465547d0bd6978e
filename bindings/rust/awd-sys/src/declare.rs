// SPDX-License-Identifier: Apache-2.0
//! Macros with which the other modules declare things, so that what is declared is listed too: a
//! test compares the lists with the C headers.

/// Handles: pointers to what only the library knows.
macro_rules! handles {
    ($( $(#[$meta:meta])* $name:ident = *mut $object:ident; )*) => { $(
        #[doc(hidden)]
        #[repr(C)]
        #[derive(Debug)]
        pub struct $object {
            nothing: [u8; 0],
        }
        $(#[$meta])*
        pub type $name = *mut $object;
    )* };
}

macro_rules! constants {
    ($( $name:ident: $type:ty = $value:expr; )*) => {
        $( pub const $name: $type = $value; )*

        pub(crate) fn constants() -> Vec<(&'static str, i64)> {
            vec![ $( (stringify!($name), i64::from($name)), )* ]
        }
    };
}

macro_rules! structs {
    ($( pub struct $name:ident { $( $field:ident: $type:ty, )* } )*) => {
        $(
            #[repr(C)]
            #[derive(Clone, Copy, Debug)]
            pub struct $name {
                $( pub $field: $type, )*
            }

            impl crate::declared::Kind for $name {
                const KIND: &'static str = "other";
            }

            impl crate::declared::Layout for $name {
                fn layout() -> crate::declared::Struct {
                    let space = std::mem::MaybeUninit::<$name>::uninit();
                    let whole = space.as_ptr();
                    crate::declared::Struct {
                        name: stringify!($name),
                        size: std::mem::size_of::<$name>(),
                        fields: vec![ $( crate::declared::Field {
                            name: stringify!($field),
                            // Safety: the address of a field is taken; nothing is read.
                            offset: unsafe { std::ptr::addr_of!((*whole).$field) } as usize
                                - whole as usize,
                            size: std::mem::size_of::<$type>(),
                            kind: <$type as crate::declared::Kind>::KIND,
                        }, )* ],
                    }
                }
            }
        )*

        pub(crate) fn structs() -> Vec<crate::declared::Struct> {
            vec![ $( <$name as crate::declared::Layout>::layout(), )* ]
        }
    };
}

/// `Default` for the structs that have an `..._INIT` macro: all zero but for structSize and what is
/// listed.
macro_rules! inits {
    ($( $name:ident $({ $( $field:ident: $value:expr, )* })?; )*) => {
        $(
            impl Default for $name {
                fn default() -> Self {
                    // Safety: integers, floats, pointers and optional functions may all be zero.
                    let zero: Self = unsafe { std::mem::zeroed() };
                    Self {
                        structSize: std::mem::size_of::<Self>(),
                        $( $( $field: $value, )* )?
                        ..zero
                    }
                }
            }
        )*

        pub(crate) fn inits() -> Vec<crate::declared::Init> {
            vec![ $( crate::declared::Init::of::<$name>(), )* ]
        }
    };
}

macro_rules! functions {
    ($( fn $name:ident($( $argument:ident: $type:ty ),* $(,)?) $( -> $result:ty )?; )*) => {
        extern "C" {
            $( pub fn $name($( $argument: $type ),*) $( -> $result )?; )*
        }

        pub(crate) fn functions() -> Vec<crate::declared::Function> {
            vec![ $( crate::declared::Function {
                name: stringify!($name),
                result: crate::declared::first(&[
                    $( <$result as crate::declared::Kind>::KIND, )? "void"
                ]),
                arguments: vec![ $( <$type as crate::declared::Kind>::KIND, )* ],
            }, )* ]
        }
    };
}
