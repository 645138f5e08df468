package org.u2sa.estimation;

import java.util.Set;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateField;
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

  /**
   * Watches the states of a service that estimates only some numbers; changes take effect at its
   * next start.
   *
   * @throws BadInputException if the vehicle needs a number that it never estimates
   */
  static Completeness watch(U2SAService service, Set<StateField> estimated) {
    for (StateField field :
        Completeness.fields(service.settings(NeededNumbers.class).get().needed)) {
      if (!estimated.contains(field)) {
        throw new BadInputException(
            String.format(
                "variable \"NEEDED\": \"%s\": %s does not estimate it",
                field.fieldName(), service.getClass().getSimpleName()));
      }
    }
    return watch(service);
  }

  /** Watches the states of a service; changes take effect at its next start. */
  static Completeness watch(U2SAService service) {
    NeededNumbers numbers = service.settings(NeededNumbers.class).get();
    return new Completeness(
        service, Completeness.fields(numbers.needed), Clock.micros(numbers.completeWithin));
  }
}
