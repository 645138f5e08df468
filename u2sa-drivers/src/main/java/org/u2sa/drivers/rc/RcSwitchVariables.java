package org.u2sa.drivers.rc;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The configuration variables of the switch between automatic and manual. */
public final class RcSwitchVariables {
  static final VariableDeclaration<Double> AUTOMATIC_ABOVE =
      VariableDeclaration.number("RC AUTOMATIC ABOVE", "us")
          .range(Range.of(1000.0, 2000.0))
          .ifAbsent(1700.0)
          .describedAs("Pulse of the radio's switch above which commands are obeyed.");

  static final VariableDeclaration<Double> HYSTERESIS =
      VariableDeclaration.number("RC HYSTERESIS", "us")
          .range(Range.of(0.0, 150.0))
          .ifAbsent(100.0)
          .describedAs("How much shorter the pulse must be to be manual again.");

  static final VariableDeclaration<Integer> CONFIRMATIONS =
      VariableDeclaration.integer("RC CONFIRMATIONS")
          .range(Range.of(1, 50))
          .ifAbsent(3)
          .describedAs("Pulses in a row that automatic needs; manual needs one.");

  static final VariableDeclaration<Double> TIMEOUT =
      VariableDeclaration.number("RC TIMEOUT", "s")
          .range(Range.of(0.05, 5.0))
          .ifAbsent(0.25)
          .describedAs("Without a pulse for longer the receiver counts as lost: manual.");

  private RcSwitchVariables() {}

  /** Declares and reads them. */
  public static RcSwitch read(Configurator variables) {
    return new RcSwitch(
        RcChannel.STANDARD,
        variables.getVariable(AUTOMATIC_ABOVE),
        variables.getVariable(HYSTERESIS),
        variables.getVariable(CONFIRMATIONS),
        variables.getVariable(TIMEOUT));
  }
}
