package org.u2sa.testkit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Repeatable;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * The test, or every test of the class, needs a program that is not Java's. Where it is missing the
 * test prints one line that says so and is skipped, before any of it runs; where the environment
 * says {@code CI=true} it fails.
 */
@Documented
@Inherited
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.TYPE, ElementType.METHOD})
@Repeatable(NeedsProgram.All.class)
@ExtendWith(NeedsProgramCondition.class)
public @interface NeedsProgram {
  /** Its name on the path, without folders: {@code socat}. */
  String value();

  /** What a Python must be able to import: {@code cbor2}; empty for all other programs. */
  String[] modules() default {};

  /** Several programs, all of them needed. */
  @Documented
  @Inherited
  @Retention(RetentionPolicy.RUNTIME)
  @Target({ElementType.TYPE, ElementType.METHOD})
  @ExtendWith(NeedsProgramCondition.class)
  @interface All {
    /** Each program. */
    NeedsProgram[] value();
  }
}
