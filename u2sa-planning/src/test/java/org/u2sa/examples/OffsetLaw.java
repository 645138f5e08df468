package org.u2sa.examples;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.GuidanceLaw;
import org.u2sa.planning.guidance.GuidanceLawProvider;

/** An extension's guidance law: beside the line instead of on it. */
public final class OffsetLaw implements GuidanceLawProvider {
  private record Variables(
      @Variable(unit = "m", min = -100, max = 100, ifAbsent = 3)
          @Description("How far to the right of the line to go.")
          double sideOffset) {}

  @Override
  public String name() {
    return "OFFSET";
  }

  @Override
  public GuidanceLaw law(Configurator configuration) {
    Settings<Variables> tuning = configuration.settings(Variables.class);
    return (leg, lookAheadM) -> {
      double along = leg.alongM(0.0, 0.0) + lookAheadM;
      double right = leg.bearingRad() + Math.PI / 2.0;
      double offsetM = tuning.get().sideOffset();
      return Point.of(
          leg.northAtM(along) + offsetM * Math.cos(right),
          leg.eastAtM(along) + offsetM * Math.sin(right),
          0.0);
    };
  }
}
