package org.u2sa.control.fixedwing;

import java.util.function.Supplier;
import org.u2sa.control.fixedwing.law.EnergyParameters;
import org.u2sa.control.fixedwing.law.FlareLaw;
import org.u2sa.control.fixedwing.law.GroundSteering;
import org.u2sa.control.fixedwing.law.GuidanceParameters;
import org.u2sa.control.fixedwing.law.PitchLaw;
import org.u2sa.control.fixedwing.law.RollLaw;
import org.u2sa.control.fixedwing.law.YawLaw;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;

/** All gains and limits of {@link Autopilot}, in configuration units. */
record Tuning(
    GuidanceParameters guidance,
    RollLaw.Parameters roll,
    PitchLaw.Parameters pitch,
    YawLaw.Parameters yaw,
    EnergyParameters energy,
    TakeOffSequence.Parameters takeOff,
    GroundSteering.Parameters ground,
    ClimbOut climbOut,
    Hold hold,
    FlareLaw.Parameters flare,
    TouchDown.Parameters touchDown) {
  /** One knot [m/s]. */
  static final double KNOT_MPS = 1852.0 / 3600.0;

  /** Behaviour without navigation. */
  record Hold(
      @Variable(
              unit = "s",
              min = 0,
              max = 60,
              ifAbsent = 5,
              text =
                  "Time without navigation before the aircraft circles; until then the wings stay level.")
          double holdLevelTime,
      @Variable(
              unit = "deg",
              min = 0,
              max = 30,
              ifAbsent = 15,
              text = "Bank to the right when circling without navigation; 0 flies straight on.")
          double holdBank) {}

  /** Take-off settings. */
  record ClimbOut(
      @Variable(min = 0.1, max = 0.5, ifAbsent = 0.2, text = "Throttle while the engine starts.")
          double startThrottle,
      @Variable(unit = "1/s", min = 0.05, max = 5, ifAbsent = 0.3, text = "Take-off throttle rate.")
          double throttleOpeningRate,
      @Variable(unit = "deg", min = 5, max = 13, ifAbsent = 10, text = "Pitch at rotation.")
          double rotationPitch,
      @Variable(unit = "deg/s", min = 1, max = 10, ifAbsent = 5, text = "Pitch rate at rotation.")
          double rotationRate,
      @Variable(
              unit = "kt",
              min = 60,
              max = 100,
              ifAbsent = 74,
              text = "Calibrated airspeed of the climb-out.")
          double climbOutSpeed,
      @Variable(unit = "deg", min = 0, max = 10, ifAbsent = 6, text = "Minimum climb-out pitch.")
          double climbOutPitchLowerLimit,
      @Variable(unit = "deg", min = 0, max = 30, ifAbsent = 10, text = "Maximum climb-out bank.")
          double climbOutBankLimit,
      @Variable(
              unit = "m",
              min = 50,
              max = 2000,
              ifAbsent = 250,
              text = "Distance to the aim point on the extended centreline.")
          double climbOutLookAhead) {}

  /** Declares all variables and returns a supplier of their current values. */
  static Supplier<Tuning> in(Configurator variables) {
    Settings<GuidanceParameters> guidance = variables.settings(GuidanceParameters.class);
    Settings<RollLaw.Parameters> roll = variables.settings(RollLaw.Parameters.class);
    Settings<PitchLaw.Parameters> pitch = variables.settings(PitchLaw.Parameters.class);
    Settings<YawLaw.Parameters> yaw = variables.settings(YawLaw.Parameters.class);
    Settings<EnergyParameters> energy = variables.settings(EnergyParameters.class);
    Settings<TakeOffSequence.Parameters> takeOff =
        variables.settings(TakeOffSequence.Parameters.class);
    Settings<GroundSteering.Parameters> ground =
        variables.settings(GroundSteering.Parameters.class);
    Settings<ClimbOut> climbOut = variables.settings(ClimbOut.class);
    Settings<Hold> hold = variables.settings(Hold.class);
    Settings<FlareLaw.Parameters> flare = variables.settings(FlareLaw.Parameters.class);
    Settings<TouchDown.Parameters> touchDown = variables.settings(TouchDown.Parameters.class);
    return () ->
        new Tuning(
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
