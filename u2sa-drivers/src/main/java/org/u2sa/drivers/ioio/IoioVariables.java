package org.u2sa.drivers.ioio;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The configuration variables that say what is wired to which pin. */
final class IoioVariables {
  private static final Range PIN = Range.of(-1.0, 48.0);
  private static final Range BAUD = Range.of(300.0, 1_000_000.0);

  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("")
          .describedAs(
              "Way to the board: serial:/dev/ttyACM0 or tcp:host:port; empty where the host brings it, as a phone does.");

  static final VariableDeclaration<String> BOARD =
      VariableDeclaration.text("BOARD")
          .oneOf("otg", "v1")
          .ifAbsent("otg")
          .describedAs("IOIO-OTG, or the IOIO before it: which pins there are.");

  static final VariableDeclaration<String> ACTUATORS =
      VariableDeclaration.text("ACTUATORS")
          .ifAbsent("LEFT MOTOR=10, RIGHT MOTOR=11")
          .describedAs("Actuators with the pins at which they get servo pulses.");

  static final VariableDeclaration<Boolean> TOGETHER =
      VariableDeclaration.flag("ACTUATORS TOGETHER")
          .ifAbsent(true)
          .describedAs("Whether all actuators are neutral while one of them has no command.");

  static final VariableDeclaration<Integer> PULSES =
      VariableDeclaration.integer("PULSE RATE", "Hz")
          .range(Range.of(20.0, 190.0)) // a period is longer than the longest pulse, 5 ms
          .ifAbsent(50)
          .describedAs("Servo pulses a second.");

  static final VariableDeclaration<Integer> GPS_RECEIVE =
      pin("GPS RX PIN", 6, "Pin at which the GPS's bytes come; -1: no GPS at the board.");

  static final VariableDeclaration<Integer> GPS_TRANSMIT =
      pin("GPS TX PIN", 7, "Pin to the GPS; -1: none, then it is not set up.");

  static final VariableDeclaration<Integer> GPS_BAUD =
      VariableDeclaration.integer("GPS BAUD", "baud")
          .range(BAUD)
          .ifAbsent(9600)
          .describedAs("Rate of the GPS's line.");

  static final VariableDeclaration<Integer> COMPASS_RECEIVE =
      pin(
          "COMPASS RX PIN",
          13,
          "Pin at which the compass's bytes come; -1: no compass at the board.");

  static final VariableDeclaration<Integer> COMPASS_TRANSMIT =
      pin("COMPASS TX PIN", 14, "Pin to the compass; -1: none.");

  static final VariableDeclaration<Integer> COMPASS_BAUD =
      VariableDeclaration.integer("COMPASS BAUD", "baud")
          .range(BAUD)
          .ifAbsent(9600)
          .describedAs("Rate of the compass's line.");

  static final VariableDeclaration<Integer> RADIO =
      pin(
          "RC SWITCH PIN",
          35,
          "Pin of the radio receiver's switch channel; -1: no radio, commands are always obeyed.");

  static final VariableDeclaration<Integer> BATTERY =
      pin("BATTERY PIN", 40, "Analog input of the battery's voltage; -1: not measured.");

  static final VariableDeclaration<Double> DIVIDER =
      VariableDeclaration.number("BATTERY DIVIDER", "")
          .range(Range.of(1.0, 100.0))
          .ifAbsent(5.0)
          .describedAs("The battery's voltage by that at the pin.");

  static final VariableDeclaration<Integer> LED =
      pin("LED PIN", 0, "Pin of the status LED; -1: none.");

  static final VariableDeclaration<Double> SILENT_AFTER =
      VariableDeclaration.number("BOARD SILENT AFTER", "s")
          .range(Range.of(0.1, 60.0))
          .ifAbsent(1.0)
          .describedAs("Time without a byte of the board after which it counts as lost.");

  private IoioVariables() {}

  private static VariableDeclaration<Integer> pin(String name, int pin, String description) {
    return VariableDeclaration.integer(name).range(PIN).ifAbsent(pin).describedAs(description);
  }

  /** An actuator and its pin. */
  record ActuatorPin(String name, int pin) {}

  /**
   * The actuators.
   *
   * @throws BadInputException naming the variable, if it is not "NAME=PIN, NAME=PIN"
   */
  static List<ActuatorPin> actuators(Configurator variables) {
    String text = variables.getVariable(ACTUATORS);
    List<ActuatorPin> actuators = new ArrayList<>();
    for (String part : text.split(",")) {
      int equals = part.indexOf('=');
      String name = equals < 0 ? "" : part.substring(0, equals).trim();
      try {
        if (name.isEmpty() || actuators.stream().anyMatch(other -> other.name().equals(name))) {
          throw new NumberFormatException("no name, or one that is there already");
        }
        actuators.add(new ActuatorPin(name, Integer.parseInt(part.substring(equals + 1).trim())));
      } catch (NumberFormatException e) {
        throw new BadInputException(
            "variable \"ACTUATORS\": \""
                + part.trim()
                + "\": expected NAME=PIN, each name once, with commas between",
            e);
      }
    }
    return actuators;
  }

  /**
   * The pins.
   *
   * @throws BadInputException naming the variable, if a pin is not there, cannot do what it is for,
   *     or is used twice
   */
  static PinPlan plan(Configurator variables, List<ActuatorPin> actuators) {
    PinDesk desk = new PinDesk(variables.getVariable(BOARD).equals("otg"));
    List<Integer> pulses = new ArrayList<>();
    for (ActuatorPin actuator : actuators) {
      if (actuator.pin() < 0) {
        throw new BadInputException("variable \"ACTUATORS\": pin " + actuator.pin() + " is none");
      }
      pulses.add(desk.take(ACTUATORS.name(), actuator.pin(), PinFunction.PERIPHERAL_OUTPUT));
    }
    Optional<UartPins> gps = uart(variables, desk, GPS_RECEIVE, GPS_TRANSMIT, GPS_BAUD);
    Optional<UartPins> compass =
        uart(variables, desk, COMPASS_RECEIVE, COMPASS_TRANSMIT, COMPASS_BAUD);
    int radio = take(variables, desk, RADIO, PinFunction.PERIPHERAL_INPUT);
    int battery = take(variables, desk, BATTERY, PinFunction.ANALOG_INPUT);
    int led = take(variables, desk, LED, PinFunction.OUTPUT);
    int sample = battery == PinPlan.NONE ? desk.anyAnalogInput() : battery;
    int rateHz = variables.getVariable(PULSES);
    return new PinPlan(pulses, rateHz, gps, compass, radio, battery, sample, led);
  }

  private static Optional<UartPins> uart(
      Configurator variables,
      PinDesk desk,
      VariableDeclaration<Integer> receive,
      VariableDeclaration<Integer> transmit,
      VariableDeclaration<Integer> baud) {
    int in = take(variables, desk, receive, PinFunction.PERIPHERAL_INPUT);
    int rate = variables.getVariable(baud);
    if (in == PinPlan.NONE) {
      variables.getVariable(transmit); // declared, though it has no meaning then
      return Optional.empty();
    }
    int out = take(variables, desk, transmit, PinFunction.PERIPHERAL_OUTPUT);
    return Optional.of(new UartPins(in, out, rate));
  }

  private static int take(
      Configurator variables,
      PinDesk desk,
      VariableDeclaration<Integer> pin,
      PinFunction function) {
    return desk.take(pin.name(), variables.getVariable(pin), function);
  }
}
