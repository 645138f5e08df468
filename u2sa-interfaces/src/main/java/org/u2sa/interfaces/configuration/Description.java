package org.u2sa.interfaces.configuration;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Describes a {@link Variable} in place of {@link Variable#text}, for sentences of some length. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.PARAMETER)
public @interface Description {
  /** Description for the user who sets the variable. */
  String value();
}
