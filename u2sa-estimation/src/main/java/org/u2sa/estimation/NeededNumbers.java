package org.u2sa.estimation;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.U2SAService;

/** Variables of an estimator: which values of the state must not be absent for long. */
record NeededNumbers(
    @Variable(ifAbsentText = "x, y, psi")
        @Description(
            "State values that the vehicle needs; health reports those absent for longer than COMPLETE WITHIN.")
        String needed,
    @Variable(unit = "s", min = 0, minExcluded = true, ifAbsent = 5)
        @Description("Time for which a needed value may be absent before health reports it.")
        double completeWithin) {
  NeededNumbers {
    try {
      Completeness.fields(needed);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("NEEDED: " + e.getMessage(), e);
    }
  }

  /** Watches the states of a service; changes take effect at its next start. */
  static Completeness watch(U2SAService service) {
    NeededNumbers numbers = service.settings(NeededNumbers.class).get();
    return new Completeness(
        service, Completeness.fields(numbers.needed), Clock.micros(numbers.completeWithin));
  }
}
