package org.u2sa.control.fixedwing;

import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;

/** All gains and limits of {@link Autopilot}, in configuration units. */
record AutopilotVariables(
    GuidanceVariables guidance,
    RollLaw.Variables roll,
    PitchLaw.Variables pitch,
    YawLaw.Variables yaw,
    EnergyLaw.Variables energy,
    TakeOffSequence.Variables takeOff,
    GroundSteering.Variables ground,
    ClimbOut climbOut,
    Hold hold,
    FlareLaw.Variables flare,
    TouchDown.Variables touchDown) {
  /** One knot [m/s]. */
  static final double KNOT_MPS = 1852.0 / 3600.0;

  /** Behaviour without navigation. */
  record Hold(
      @Variable(unit = "s", min = 0, max = 60, ifAbsent = 5)
          @Description(
              "Time without navigation before the aircraft circles; until then the wings stay level.")
          double holdLevelTime,
      @Variable(unit = "deg", min = 0, max = 30, ifAbsent = 15)
          @Description("Bank to the right when circling without navigation; 0 flies straight on.")
          double holdBank) {}

  /** Take-off settings. */
  record ClimbOut(
      @Variable(min = 0.1, max = 0.5, ifAbsent = 0.2)
          @Description("Throttle while the engine starts.")
          double startThrottle,
      @Variable(unit = "1/s", min = 0.05, max = 5, ifAbsent = 0.3)
          @Description("Take-off throttle rate.")
          double throttleOpeningRate,
      @Variable(unit = "deg", min = 5, max = 20, ifAbsent = 10) @Description("Pitch at rotation.")
          double rotationPitch,
      @Variable(unit = "deg/s", min = 1, max = 10, ifAbsent = 5)
          @Description("Pitch rate at rotation.")
          double rotationRate,
      @Variable(unit = "kt", min = 10, max = 100, ifAbsent = 74)
          @Description("Calibrated airspeed of the climb-out.")
          double climbOutSpeed,
      @Variable(unit = "deg", min = 0, max = 10, ifAbsent = 6)
          @Description("Minimum climb-out pitch.")
          double climbOutPitchLowerLimit,
      @Variable(unit = "deg", min = 0, max = 30, ifAbsent = 10)
          @Description("Maximum climb-out bank.")
          double climbOutBankLimit,
      @Variable(unit = "m", min = 20, max = 2000, ifAbsent = 250)
          @Description("Distance to the aim point on the extended centreline.")
          double climbOutLookAhead) {}

  /** Rotation speed (calibrated) [m/s]: increased by a fraction of the wind speed, for gusts. */
  double rotationMps(WindEstimate wind) {
    return KNOT_MPS * takeOff.rotationSpeed() + guidance.gustShare() * wind.speedMps();
  }

  /**
   * Pitch at rotation [rad]. Lift grows with speed squared, so at a higher speed less pitch gives
   * the same lift, leaving more margin for upward gusts.
   */
  double rotationPitchRad(WindEstimate wind) {
    double slower = KNOT_MPS * takeOff.rotationSpeed() / rotationMps(wind);
    return Math.toRadians(climbOut.rotationPitch()) * slower * slower;
  }

  /** Declares all variables and returns a supplier of their current values. */
  static Supplier<AutopilotVariables> in(Configurator variables) {
    Settings<GuidanceVariables> guidance = variables.settings(GuidanceVariables.class);
    Settings<RollLaw.Variables> roll = variables.settings(RollLaw.Variables.class);
    Settings<PitchLaw.Variables> pitch = variables.settings(PitchLaw.Variables.class);
    Settings<YawLaw.Variables> yaw = variables.settings(YawLaw.Variables.class);
    Settings<EnergyLaw.Variables> energy = variables.settings(EnergyLaw.Variables.class);
    Settings<TakeOffSequence.Variables> takeOff =
        variables.settings(TakeOffSequence.Variables.class);
    Settings<GroundSteering.Variables> ground = variables.settings(GroundSteering.Variables.class);
    Settings<ClimbOut> climbOut = variables.settings(ClimbOut.class);
    Settings<Hold> hold = variables.settings(Hold.class);
    Settings<FlareLaw.Variables> flare = variables.settings(FlareLaw.Variables.class);
    Settings<TouchDown.Variables> touchDown = variables.settings(TouchDown.Variables.class);
    return () ->
        new AutopilotVariables(
            guidance.get(),
            roll.get(),
            pitch.get(),
            yaw.get(),
            energy.get(),
            takeOff.get(),
            ground.get(),
            climbOut.get(),
            hold.get(),
            flare.get(),
            touchDown.get());
  }
}
