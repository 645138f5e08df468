package org.u2sa.examples;

import java.util.Locale;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Warns once each time that the vehicle gets too low. In: state. Out: altitude-warnings. */
public final class LowAltitudeWarning extends EventDrivenService {
  private record Variables(
      @Variable(unit = "m", min = -500, max = 20_000, ifAbsent = 100)
          @Description("Altitude above mean sea level below which the vehicle is too low.")
          double lowestAltitude,
      @Variable(unit = "m", min = 0, max = 1000, ifAbsent = 10)
          @Description("How far above the lowest altitude a warning ends.")
          double margin) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private boolean low; // touched by this service's thread only, like all that handlers use

  /** Called by the launcher. */
  public LowAltitudeWarning(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "LowAltitudeWarning");
    subscribe(Channels.STATE, this::onState);
    registerPublisher(AltitudeWarning.CHANNEL);
  }

  private void onState(StateInformation state) {
    if (state.referenceFrame().equals(ReferenceFrame.GLOBAL)) {
      state.z().ifPresent(this::judge);
    }
  }

  private void judge(double altitudeM) {
    double lowestM = tuning.get().lowestAltitude();
    boolean nowLow = altitudeM < (low ? lowestM + tuning.get().margin() : lowestM);
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
