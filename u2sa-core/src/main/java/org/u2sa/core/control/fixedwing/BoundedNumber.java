package org.u2sa.core.control.fixedwing;

import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** What every gain and limit of the autopilot is: a number within bounds, with a default. */
final class BoundedNumber {
  private BoundedNumber() {}

  /**
   * A variable in its unit, which {@code least}, {@code most} and {@code ifAbsent} are in as well.
   */
  static VariableDeclaration<Double> number(
      String name, String unit, double least, double most, double ifAbsent, String description) {
    return VariableDeclaration.number(name, unit)
        .range(Range.of(least, most))
        .ifAbsent(ifAbsent)
        .describedAs(description);
  }
}
