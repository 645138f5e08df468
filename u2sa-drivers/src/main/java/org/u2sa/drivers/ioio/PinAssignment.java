package org.u2sa.drivers.ioio;

import java.util.Map;
import java.util.TreeMap;
import org.u2sa.interfaces.BadInputException;

/** Which pins are taken: each once, and only for what it can do. */
final class PinAssignment {
  private final boolean isOtg;
  private final Map<Integer, String> taken = new TreeMap<>(); // variable by pin

  PinAssignment(boolean isOtg) {
    this.isOtg = isOtg;
  }

  /**
   * Takes a pin.
   *
   * @param variable which configures it, for the error
   * @param pin its number; {@link PinPlan#NONE} takes nothing
   * @return the number
   * @throws BadInputException if there is no such pin, it lacks the function, or it is taken
   */
  int take(String variable, int pin, PinFunction function) {
    if (pin == PinPlan.NONE) {
      return pin;
    }
    String subject = "variable \"" + variable + "\": pin " + pin;
    int last = PinFunction.lastPin(isOtg);
    if (pin < 0 || pin > last) {
      throw new BadInputException(subject + " is outside 0…" + last + (isOtg ? " of an OTG" : ""));
    }
    if (!function.isAt(pin, isOtg)) {
      throw new BadInputException(subject + " cannot be " + function.words());
    }
    String other = taken.putIfAbsent(pin, variable);
    if (other != null) {
      throw new BadInputException(subject + " is taken by variable \"" + other + "\"");
    }
    return pin;
  }

  /**
   * An analog input that nobody took.
   *
   * @throws BadInputException if all are taken
   */
  int anyAnalogInput() {
    for (int pin = PinFunction.FIRST_ANALOG; pin <= PinFunction.LAST_ANALOG; pin++) {
      if (!taken.containsKey(pin)) {
        return pin;
      }
    }
    throw new BadInputException(
        "IOIO: all analog inputs are taken; one must be free, or measure the battery");
  }
}
