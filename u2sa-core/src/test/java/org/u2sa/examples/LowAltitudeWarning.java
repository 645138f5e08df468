package org.u2sa.examples;

import java.util.Locale;
import java.util.Set;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Warns once each time that the vehicle gets too low. In: state. Out: altitude-warnings. */
public final class LowAltitudeWarning extends EventDrivenService {
  private static final VariableDeclaration<Double> LOWEST_ALTITUDE =
      VariableDeclaration.number("LOWEST ALTITUDE", "m")
          .range(Range.of(-500.0, 20_000.0))
          .ifAbsent(100.0)
          .describedAs("Altitude above mean sea level below which the vehicle is too low.");

  private static final VariableDeclaration<Double> MARGIN =
      VariableDeclaration.number("MARGIN", "m")
          .range(Range.of(0.0, 1_000.0))
          .ifAbsent(10.0)
          .describedAs("How far above the lowest altitude a warning ends.");

  private double lowestM;
  private double marginM;
  private boolean low; // touched by this service's thread only, like all that callback uses

  /** Reads the variables and registers; the launcher calls this. */
  public LowAltitudeWarning(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "LowAltitudeWarning");
    configurationChanged(Set.of());
    registerSubscriber(StateInformation.class); // an observer's standard channel for it: state
    registerPublisher(AltitudeWarning.CHANNEL);
  }

  /** Also called when somebody changes a variable while the service runs. */
  @Override
  protected void configurationChanged(Set<String> variableNames) {
    lowestM = getVariable(LOWEST_ALTITUDE);
    marginM = getVariable(MARGIN);
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof StateInformation state
        && state.referenceFrame().equals(ReferenceFrame.GLOBAL)) {
      state.z().ifPresent(this::judge);
    } else {
      unexpected(data); // logged for debugging, thesis 8.2.4
    }
  }

  private void judge(double altitudeM) {
    boolean nowLow = altitudeM < (low ? lowestM + marginM : lowestM);
    if (nowLow == low) {
      return;
    }
    low = nowLow;
    log(
        low ? LogLevelEnum.WARN : LogLevelEnum.INFO,
        String.format(Locale.ROOT, "%s at %.1f m", low ? "too low" : "high enough", altitudeM));
    publish(new AltitudeWarning().low(low).altitude(altitudeM));
  }
}
