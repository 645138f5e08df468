package org.u2sa.service.actuator;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;

/**
 * Configured description of an actuator, for its announcement: {@code
 * settings(ActuatorDescription.class)}, with the actuator's name as prefix if the service has
 * several.
 */
public record ActuatorDescription(
    @Variable(ifAbsentText = "")
        @Description(
            "Force and moment on the vehicle at full command, in forward, right and down axes: \"thrust 40 / 30 at 0.16 -0.11 0 towards 1 1 0\" in N and m, the second number being the reverse thrust, or \"wrench X Y Z K M N\" in N and N m; empty: no effect is announced.")
        String effect,
    @Variable(min = 0.1, max = 10, ifAbsent = 1)
        @Description("The effect grows with this power of the command; about 2 for propellers.")
        double effectExponent,
    @Variable(unit = "m/s", min = 0, max = 1000, ifAbsent = 0)
        @Description(
            "Speed through air or water at which the effect holds; it scales with speed squared. 0: independent of speed.")
        double effectSpeed,
    @Variable(unit = "%", min = 0, max = 99, ifAbsent = 0)
        @Description("Dead band: smaller commands have no effect.")
        double deadband,
    @Variable(unit = "%/s", min = 0, max = 1.0e6, ifAbsent = 0)
        @Description("Maximum rate of change to announce; 0: immediate.")
        double rateLimit,
    @Variable(unit = "s", min = 0, max = 60, ifAbsent = 0)
        @Description("Time constant of the response; 0: unknown.")
        double timeConstant,
    @Variable(unit = "deg", min = -360, max = 360, ifAbsent = 0)
        @Description("Angle at +100 %, needed to accept angle commands; 0: none accepted.")
        double fullAngle,
    @Variable(unit = "rad/s", min = -10_000, max = 10_000, ifAbsent = 0)
        @Description(
            "Rotation speed at +100 %, needed to accept rotation-speed commands; 0: none accepted.")
        double fullSpeed,
    @Variable(unit = "s", min = 0, max = 60, ifAbsent = 0)
        @Description(
            "Time between announcements: control drops an actuator that misses three; 0: 0.25 s with EFFECT, otherwise 5 s.")
        double renewal) {
  /** Announcement period of an allocated actuator [s]; control drops it within a second. */
  private static final double ALLOCATED_RENEWAL_S = 0.25;

  public ActuatorDescription {
    if (!effect.trim().isEmpty()) {
      EffectText.parse(effect);
    }
  }

  /**
   * Writes a thruster's effect into an announcement, for services with their own variables for it.
   *
   * @param place position relative to the vehicle's reference point: forward, right, down [m]
   * @param direction thrust direction at +100 %, in the same axes, of any length
   * @param forwardN thrust at +100 % [N]
   * @param reverseN thrust at −100 % [N]
   */
  public static ActuatorAnnouncement addThrust(
      ActuatorAnnouncement announcement,
      Point place,
      Point direction,
      double forwardN,
      double reverseN) {
    return EffectText.ofThrust(place, direction, forwardN, reverseN)
        .addTo(announcement)
        .renewal(ALLOCATED_RENEWAL_S);
  }

  /**
   * Writes the effect of a control surface into an announcement, for services with their own
   * variables for it.
   *
   * @param effect as in {@link #effect}; empty: none
   * @param speedMps as in {@link #effectSpeed}
   * @throws IllegalArgumentException if the effect is malformed
   */
  public static ActuatorAnnouncement addEffect(
      ActuatorAnnouncement announcement, String effect, double speedMps) {
    if (!effect.trim().isEmpty()) {
      EffectText.parse(effect).addTo(announcement);
      announcement.renewal(ALLOCATED_RENEWAL_S);
    }
    return speedMps > 0.0 ? announcement.referenceSpeed(speedMps) : announcement;
  }

  public ActuatorAnnouncement addTo(ActuatorAnnouncement announcement) {
    List<String> types = new ArrayList<>(announcement.commandTypes());
    addEffect(announcement, effect, effectSpeed);
    if (!effect.trim().isEmpty()) {
      if (announcement.force().orElseThrow().distance() > 0.0) {
        types.add("ForceCommand");
      }
    }
    if (effectExponent != 1.0) {
      announcement.exponent(effectExponent);
    }
    if (deadband > 0.0) {
      announcement.deadband(deadband);
    }
    if (rateLimit > 0.0) {
      announcement.rateLimit(rateLimit);
    }
    if (timeConstant > 0.0) {
      announcement.timeConstant(timeConstant);
    }
    if (fullAngle != 0.0) {
      announcement.fullAngle(Math.toRadians(fullAngle));
      types.add("AngleCommand");
    }
    if (fullSpeed != 0.0) {
      announcement.fullSpeed(fullSpeed);
      types.add("SpeedCommand");
    }
    if (renewal > 0.0) {
      announcement.renewal(renewal);
    }
    return types.isEmpty() ? announcement : announcement.commandTypes(types);
  }
}
