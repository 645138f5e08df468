package org.u2sa.drivers.ioio;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Configuration variables for the pin assignment. */
record IoioVariables(
    @Variable(ifAbsentText = "")
        @Description(
            "Address of the board: serial:/dev/ttyACM0, tcp:host:port, or tls:host:port with a user; empty: the host connects it, as a phone does.")
        String connection,
    @Variable(
            ifAbsentText = "otg",
            oneOf = {"otg", "v1"})
        @Description("Type of the board, which determines its pins: IOIO-OTG, or the earlier IOIO.")
        String board,
    @Variable(ifAbsentText = "LEFT MOTOR=10, RIGHT MOTOR=11")
        @Description("Actuators and the pins of their servo pulses.")
        String actuators,
    @Variable(ifAbsentText = "true")
        @Description("Whether all actuators are neutral while one of them has no command.")
        boolean actuatorsTogether,
    // a period must exceed the longest pulse, 5 ms
    @Variable(unit = "Hz", min = 20, max = 190, ifAbsent = 50)
        @Description("Servo pulses per second.")
        int pulseRate,
    @Variable(min = -1, max = 48, ifAbsent = 6)
        @Description("RX pin of the GPS; -1: no GPS at the board.")
        int gpsRxPin,
    @Variable(min = -1, max = 48, ifAbsent = 7)
        @Description("TX pin of the GPS; -1: none, so the GPS is not configured.")
        int gpsTxPin,
    @Variable(unit = "baud", min = 300, max = 1_000_000, ifAbsent = 9600)
        @Description("Baud rate of the GPS.")
        int gpsBaud,
    @Variable(min = -1, max = 48, ifAbsent = 13)
        @Description("RX pin of the compass; -1: no compass at the board.")
        int compassRxPin,
    @Variable(min = -1, max = 48, ifAbsent = 14) @Description("TX pin of the compass; -1: none.")
        int compassTxPin,
    @Variable(unit = "baud", min = 300, max = 1_000_000, ifAbsent = 9600)
        @Description("Baud rate of the compass.")
        int compassBaud,
    @Variable(min = -1, max = 48, ifAbsent = 35)
        @Description(
            "Pin of the radio receiver's switch channel; -1: no radio, commands are always obeyed.")
        int rcSwitchPin,
    @Variable(min = -1, max = 48, ifAbsent = 40)
        @Description("Analog input of the battery's voltage; -1: not measured.")
        int batteryPin,
    @Variable(min = 1, max = 100, ifAbsent = 5)
        @Description("Ratio of the voltage divider: battery voltage over pin voltage.")
        double batteryDivider,
    @Variable(min = -1, max = 48, ifAbsent = 0) @Description("Pin of the status LED; -1: none.")
        int ledPin,
    @Variable(unit = "s", min = 0.1, max = 60, ifAbsent = 1)
        @Description(
            "Time without a byte from the board, or without an answer to a message, after which it counts as lost.")
        double boardSilentAfter) {
  /** An actuator and its pin. */
  record ActuatorPin(String name, int pin) {}

  /**
   * Parses the actuators.
   *
   * @throws BadInputException naming the variable, if it is not "NAME=PIN, NAME=PIN"
   */
  List<ActuatorPin> actuatorPins() {
    List<ActuatorPin> pins = new ArrayList<>();
    for (String part : actuators.split(",")) {
      int equals = part.indexOf('=');
      String name = equals < 0 ? "" : part.substring(0, equals).trim();
      try {
        if (name.isEmpty() || pins.stream().anyMatch(other -> other.name().equals(name))) {
          throw new NumberFormatException("no name, or a duplicate");
        }
        pins.add(new ActuatorPin(name, Integer.parseInt(part.substring(equals + 1).trim())));
      } catch (NumberFormatException e) {
        throw new BadInputException(
            "variable \"ACTUATORS\": \""
                + part.trim()
                + "\": expected NAME=PIN, each name once, separated by commas",
            e);
      }
    }
    return pins;
  }

  /**
   * Validates and assigns the pins.
   *
   * @throws BadInputException naming the variable, if a pin does not exist, lacks the function, or
   *     is used twice
   */
  PinPlan plan() {
    PinAssignment pins = new PinAssignment(board.equals("otg"));
    List<Integer> pulses = new ArrayList<>();
    for (ActuatorPin actuator : actuatorPins()) {
      if (actuator.pin() < 0) {
        throw new BadInputException("variable \"ACTUATORS\": pin " + actuator.pin() + " is none");
      }
      pulses.add(pins.take("ACTUATORS", actuator.pin(), PinFunction.PERIPHERAL_OUTPUT));
    }
    Optional<PinPlan.Uart> gps = uart(pins, "GPS", gpsRxPin, gpsTxPin, gpsBaud);
    Optional<PinPlan.Uart> compass = uart(pins, "COMPASS", compassRxPin, compassTxPin, compassBaud);
    int radio = pins.take("RC SWITCH PIN", rcSwitchPin, PinFunction.PERIPHERAL_INPUT);
    int battery = pins.take("BATTERY PIN", batteryPin, PinFunction.ANALOG_INPUT);
    int led = pins.take("LED PIN", ledPin, PinFunction.OUTPUT);
    int sample = battery == PinPlan.NONE ? pins.anyAnalogInput() : battery;
    return new PinPlan(pulses, pulseRate, gps, compass, radio, battery, sample, led);
  }

  private static Optional<PinPlan.Uart> uart(
      PinAssignment pins, String device, int receive, int transmit, int baud) {
    if (receive == PinPlan.NONE) {
      return Optional.empty();
    }
    int in = pins.take(device + " RX PIN", receive, PinFunction.PERIPHERAL_INPUT);
    int out = pins.take(device + " TX PIN", transmit, PinFunction.PERIPHERAL_OUTPUT);
    return Optional.of(new PinPlan.Uart(in, out, baud));
  }

  /** Assigned pins: each used once and only for a supported function. */
  private static final class PinAssignment {
    private final boolean isOtg;
    private final Map<Integer, String> taken = new TreeMap<>(); // variable by pin

    PinAssignment(boolean isOtg) {
      this.isOtg = isOtg;
    }

    /**
     * Assigns a pin.
     *
     * @param variable configuration variable, for the error
     * @param pin number; {@link PinPlan#NONE} assigns nothing
     * @return the number
     * @throws BadInputException if the pin does not exist, lacks the function, or is in use
     */
    int take(String variable, int pin, PinFunction function) {
      if (pin == PinPlan.NONE) {
        return pin;
      }
      String subject = "variable \"" + variable + "\": pin " + pin;
      int last = PinFunction.lastPin(isOtg);
      if (pin < 0 || pin > last) {
        throw new BadInputException(
            subject + " is outside 0…" + last + (isOtg ? " of an OTG" : ""));
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
     * Finds an unused analog input.
     *
     * @throws BadInputException if all are in use
     */
    int anyAnalogInput() {
      for (int pin = PinFunction.FIRST_ANALOG; pin <= PinFunction.LAST_ANALOG; pin++) {
        if (!taken.containsKey(pin)) {
          return pin;
        }
      }
      throw new BadInputException(
          "IOIO: all analog inputs are taken; one must be free or measure the battery");
    }
  }
}
