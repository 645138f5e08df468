package org.u2sa.messages.cbor;

import java.util.HashMap;
import java.util.Map;

/**
 * Field labels: integers that replace field names on the wire, as in SenML (RFC 8428, 6) and COSE
 * (RFC 9052, 1.5). One list for all classes; names not in it, such as those of your own classes,
 * are written as text even in the labelled form.
 */
public final class FieldLabels {
  /**
   * Prefix of the field name made from an unknown label. A later reader that knows the label
   * resolves it to the name.
   */
  static final String UNKNOWN = "#";

  /**
   * A name's label is its index, from 0. Append only, so that old recordings stay readable. The
   * first 24 take one byte.
   */
  private static final String ALL =
      """
      systemId timestamp origin type sensorName referenceFrame x y z xDot yDot zDot phi theta
      psi phiDot thetaDot psiDot actuatorName percentage expiry uid xSigma ySigma xDoubleDot
      yDoubleDot zDoubleDot zSigma xDotSigma yDotSigma zDotSigma xDoubleDotSigma
      yDoubleDotSigma zDoubleDotSigma phiDoubleDot thetaDoubleDot psiDoubleDot phiSigma
      thetaSigma psiSigma phiDotSigma thetaDotSigma psiDotSigma phiDoubleDotSigma
      thetaDoubleDotSigma psiDoubleDotSigma fluidxDot fluidyDot fluidzDot fluidxDoubleDot
      fluidyDoubleDot fluidzDoubleDot fluidxDotSigma fluidyDotSigma fluidzDotSigma
      fluidxDoubleDotSigma fluidyDoubleDotSigma fluidzDoubleDotSigma completed next
      description abandoned result reason arrivedAt timeLimit choose nextIfDone nextIfFailed
      nextIfTimedOut repeatFrom repeatTimes time horizontalThreshold verticalThreshold speed
      goals upcoming landGoals fileFaults paused objectType level velocitySigma horizon
      confidence points radius length width height objects subsystem point backwards minimum
      maximum effect rateLimit deadband timeConstant force moment reverseForce reverseMoment
      exponent referenceSpeed fullAngle fullSpeed available renewal serviceName commandTypes
      serviceType status host uptime version instance className publishes subscribes stopAll
      name variableType value unit min max choices variables revision variableName accepted
      lastError inboxDepth dropped refused overruns exceptions callbackP50 callbackP99
      interval threadAlive callbackRunning dataAge published expired missed replaced
      commandsObeyed commandsRefused refusedSubscriptions emergencyStops remarks active
      operator clears stopId lifts requestId action condition since restarts causes arm armed
      reasons previous assignments author voltage current remaining minRange maxRange
      timeIncrement startAngle angleIncrement angles ranges returns rollRate pitchRate yawRate
      angularRateSigma specificForceX specificForceY specificForceZ specificForceSigma
      timeStep trajectory left bottom resolution columns rows cells goal planner cost within
      pointed mission finished sequence failsafe elapsed began resumable file now outcome
      angle format data heightAboveGround calibratedAirspeed engineRpm weightOnWheels
      engineStarting crashed phase navigating bank pitch altitude airspeed awaited landmarkX
      landmarkY range rangeSigma bearing bearingSigma colour thickness lying
      excessTemperature
      turn duration approach slope payload terminalSpeed
      corners ground lowest highest share seen image area corner cell resolutions images
      fence margin
      classes required
      pressure
      takeovers turnRate speedShare turnShare rally
      turns towardsNext photoDistance lookAt landingStart keepIn keepOut returning withheld homeAltitude
      """;

  private static final String[] NAMES = ALL.trim().split("\\s+");
  private static final Map<String, Integer> LABELS = new HashMap<>();

  static {
    for (int label = 0; label < NAMES.length; label++) {
      LABELS.put(NAMES[label], label);
    }
  }

  private FieldLabels() {}

  /** Number of labels; every smaller integer has a name. */
  public static int count() {
    return NAMES.length;
  }

  /** Label of a name; null if none. */
  public static Integer of(String name) {
    return LABELS.get(name);
  }

  /** Name of a label; a placeholder if the label is unknown. */
  public static String name(long label) {
    return label >= 0 && label < NAMES.length ? NAMES[(int) label] : UNKNOWN + label;
  }

  /** Name of a text key: the text itself, or the name of the label in a placeholder. */
  public static String name(String key) {
    if (!key.startsWith(UNKNOWN)) {
      return key;
    }
    for (int label = 0; label < NAMES.length; label++) {
      if (key.equals(UNKNOWN + label)) {
        return NAMES[label];
      }
    }
    return key;
  }
}
