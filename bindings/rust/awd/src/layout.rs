// SPDX-License-Identifier: Apache-2.0
//! Structs that are handed to C as C's own.

/// Asserts that a struct has the size of C's, and as a test that its fields lie where C's do.
macro_rules! same_layout {
    ($test:ident: $ours:ty = $theirs:ty { $( $field:ident = $name:ident, )* }) => {
        const _: () = assert!(
            std::mem::size_of::<$ours>() == std::mem::size_of::<$theirs>()
                && std::mem::align_of::<$ours>() == std::mem::align_of::<$theirs>()
        );

        #[test]
        fn $test() {
            let (ours, theirs) =
                (std::mem::MaybeUninit::<$ours>::uninit(), std::mem::MaybeUninit::uninit());
            let (ours, theirs): (*const $ours, *const $theirs) = (ours.as_ptr(), theirs.as_ptr());
            // Safety: addresses are taken; nothing is read.
            unsafe {
                $( assert_eq!(
                    std::ptr::addr_of!((*ours).$field) as usize - ours as usize,
                    std::ptr::addr_of!((*theirs).$name) as usize - theirs as usize,
                    stringify!($field)
                ); )*
            }
        }
    };
}
