package org.u2sa.interfaces.configuration;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Says that a record's component is a configuration variable. All components of the record say so:
 *
 * <pre>{@code
 * record Tuning(
 *     @Variable(unit = "m/s", min = 30, max = 60, ifAbsent = 40, text = "Speed on legs.")
 *         double cruiseSpeed,
 *     @Variable(oneOf = {"HOLD", "STOP"}, ifAbsentText = "STOP", text = "What follows the last goal.")
 *         String atEnd) {}
 *
 * private final Settings<Tuning> tuning = settings(Tuning.class); // in the service
 * }</pre>
 *
 * <p>Components are double, int, boolean, String or an enum, whose choices are its constants. The
 * record's compact constructor may check values against each other: an {@link
 * IllegalArgumentException}, which names the variables, refuses the configuration at the start, and
 * a change that leads there.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.PARAMETER) // of the canonical constructor, where Android can read it too
public @interface Variable {
  /** Default of {@link #ifAbsentText}: there is none. */
  String REQUIRED = "\0";

  /** The name in the file; without it the component's: {@code cruiseSpeed} is CRUISE SPEED. */
  String name() default "";

  /** The unit in which the service gets it, for example {@code m/s}; empty: none. */
  String unit() default "";

  /** The lowest value of a number. */
  double min() default Double.NEGATIVE_INFINITY;

  /** Excludes {@link #min} itself: the values are above it. */
  boolean minExcluded() default false;

  /** The highest value of a number. */
  double max() default Double.POSITIVE_INFINITY;

  /** A number's value if the file has none; without it the file must have one. */
  double ifAbsent() default Double.NaN;

  /** The same of a text, a boolean ({@code "false"}) or an enum (a constant's name). */
  String ifAbsentText() default REQUIRED;

  /** The only texts allowed, in exactly this case; empty: all are. */
  String[] oneOf() default {};

  /** What it does, in a sentence for the user who sets it. */
  String text();
}
