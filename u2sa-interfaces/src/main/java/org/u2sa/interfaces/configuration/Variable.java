package org.u2sa.interfaces.configuration;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a record component as a configuration variable. Every component of the record must be
 * annotated, and have a {@link Description}:
 *
 * <pre>{@code
 * record Variables(
 *     @Variable(unit = "m/s", min = 30, max = 60, ifAbsent = 40) @Description("Speed on legs.")
 *         double cruiseSpeed,
 *     @Variable(oneOf = {"HOLD", "STOP"}, ifAbsentText = "STOP")
 *         @Description("After the last goal: HOLD stays at the last waypoint, STOP stops.")
 *         String atEnd) {}
 *
 * private final Settings<Variables> tuning = settings(Variables.class); // in the service
 * }</pre>
 *
 * <p>Components are double, int, boolean, String or an enum. The compact constructor may check
 * combinations: an {@link IllegalArgumentException} naming the variables rejects the configuration
 * at startup and any such change.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.PARAMETER) // on the canonical constructor's parameters, readable on Android
public @interface Variable {
  /** Sentinel: no default. */
  String REQUIRED = "\0";

  /** Name in the file; defaults to the component name: {@code cruiseSpeed} is CRUISE SPEED. */
  String name() default "";

  /** Unit delivered to the service, for example {@code m/s}; empty for none. */
  String unit() default "";

  double min() default Double.NEGATIVE_INFINITY;

  /** Makes {@link #min} exclusive. */
  boolean minExcluded() default false;

  double max() default Double.POSITIVE_INFINITY;

  /** Numeric default; if unset, the variable is required. */
  double ifAbsent() default Double.NaN;

  /** Default for a text, boolean ({@code "false"}) or enum (constant name). */
  String ifAbsentText() default REQUIRED;

  /** Allowed texts, case-sensitive; empty for any. */
  String[] oneOf() default {};
}
