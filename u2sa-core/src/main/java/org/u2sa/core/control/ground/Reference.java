package org.u2sa.core.control.ground;

/**
 * The motion that a demanded one should have become by now: motors, tyres and sensors take their
 * time, and feedback must not take that for an error. First order; belongs to one thread.
 */
final class Reference {
  private Drive drive = Drive.STANDING;

  /**
   * @param responseS time constant of vehicle and sensors [s]
   */
  Drive step(Drive demanded, double responseS, double stepS) {
    double share = stepS / (responseS + stepS);
    drive =
        new Drive(
            drive.speedMps() + share * (demanded.speedMps() - drive.speedMps()),
            drive.yawRateRadPerS() + share * (demanded.yawRateRadPerS() - drive.yawRateRadPerS()));
    return drive;
  }
}
