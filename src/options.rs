//! Macros that define structures of options: each field is written once, with its default and a method that sets it.

/// Defines a structure of options and, for every field with a default, a method of the same name that sets it.
///
/// `Name { … }` has `Default`; `Name of { given } { … }` has `new`, which takes the fields that have no default.
macro_rules! options {
    (
        $(#[$about:meta])*
        $name:ident { $($(#[$field_about:meta])* $field:ident: $type:ty = $default:expr,)* }
    ) => {
        $crate::options::structure! {
            $(#[$about])* $name {} {
                $(
                    $(#[$field_about])*
                    #[doc = ""]
                    #[doc = concat!("Default: `", stringify!($default), "`.")]
                    $field: $type,
                )*
            }
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default,)* }
            }
        }
    };
    (
        $(#[$about:meta])*
        $name:ident
        of { $($(#[$given_about:meta])* $given:ident: $given_type:ty,)* }
        { $($(#[$field_about:meta])* $field:ident: $type:ty = $default:expr,)* }
    ) => {
        $crate::options::structure! {
            $(#[$about])* $name
            { $($(#[$given_about])* $given: $given_type,)* }
            {
                $(
                    $(#[$field_about])*
                    #[doc = ""]
                    #[doc = concat!("Default: `", stringify!($default), "`.")]
                    $field: $type,
                )*
            }
        }

        impl $name {
            /// The options with these values for the fields that have no default.
            #[must_use]
            pub fn new($($given: $given_type),*) -> Self {
                Self { $($given,)* $($field: $default,)* }
            }
        }
    };
}

/// Defines the structure itself and, for every field of the second list, a method of the same name that sets it.
macro_rules! structure {
    (
        $(#[$about:meta])*
        $name:ident
        { $($(#[$given_about:meta])* $given:ident: $given_type:ty,)* }
        { $($(#[$field_about:meta])* $field:ident: $type:ty,)* }
    ) => {
        $(#[$about])*
        #[derive(Clone, Debug)]
        #[non_exhaustive]
        pub struct $name {
            $($(#[$given_about])* pub $given: $given_type,)*
            $($(#[$field_about])* pub $field: $type,)*
        }

        impl $name {
            $(
                $(#[$field_about])*
                #[must_use]
                pub fn $field(mut self, $field: $type) -> Self {
                    self.$field = $field;
                    self
                }
            )*
        }
    };
}

pub(crate) use {options, structure};
