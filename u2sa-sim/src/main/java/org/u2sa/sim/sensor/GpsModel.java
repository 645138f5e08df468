package org.u2sa.sim.sensor;

import java.util.Random;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.world.LocalPlane;

/** A satellite receiver's errors: white noise, wandering bias, drop-outs. */
public final class GpsModel {
  private final GpsParameters p;
  private final LocalPlane plane;
  private final Random noise;
  private final Random outages;
  private final GaussMarkov biasEast;
  private final GaussMarkov biasNorth;
  private final GaussMarkov biasUp;
  private double lastS;
  private double nextOutageS;
  private double outageEndsS;

  /** Takes the streams {@code gps} and {@code gps outages}. */
  public GpsModel(GpsParameters parameters, LocalPlane plane, NoiseStreams streams) {
    this.p = parameters;
    this.plane = plane;
    this.noise = streams.of("gps");
    this.outages = streams.of("gps outages");
    Random bias = streams.of("gps bias");
    biasEast = new GaussMarkov(p.biasM(), p.biasTauS(), bias);
    biasNorth = new GaussMarkov(p.biasM(), p.biasTauS(), bias);
    biasUp = new GaussMarkov(p.biasM() * p.verticalFactor(), p.biasTauS(), bias);
    nextOutageS = p.betweenOutagesS() > 0.0 ? waitS(p.betweenOutagesS()) : Double.MAX_VALUE;
  }

  /**
   * The next position. The noise goes on during drop-outs, so that one changes nothing after it.
   *
   * @param timeS simulated time, later than at the last call [s]
   * @param blocked whether something keeps the satellites from being seen
   */
  public GpsSample sample(double timeS, TrueMotion truth, boolean blocked) {
    double dtS = timeS - lastS;
    lastS = timeS;
    double east = truth.eastM() + biasEast.step(dtS) + p.whiteM() * noise.nextGaussian();
    double north = truth.northM() + biasNorth.step(dtS) + p.whiteM() * noise.nextGaussian();
    double up =
        truth.upM() + biasUp.step(dtS) + p.whiteM() * p.verticalFactor() * noise.nextGaussian();
    double eastMps = truth.eastMps() + p.velocityMps() * noise.nextGaussian();
    double northMps = truth.northMps() + p.velocityMps() * noise.nextGaussian();
    double upMps = truth.upMps() + p.velocityMps() * noise.nextGaussian();
    if (outage(timeS) || blocked) {
      return new GpsSample(timeS, false, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    }
    Geodetic place = plane.at(east, north, up);
    return new GpsSample(
        timeS,
        true,
        place.latitudeDeg(),
        place.longitudeDeg(),
        place.altitudeM(),
        eastMps,
        northMps,
        upMps,
        p.horizontalSigmaM(),
        p.horizontalSigmaM() * p.verticalFactor(),
        p.velocityMps(),
        p.satellites(),
        p.quality());
  }

  private boolean outage(double timeS) {
    while (timeS >= nextOutageS) {
      outageEndsS = nextOutageS + waitS(p.outageS());
      nextOutageS = outageEndsS + waitS(p.betweenOutagesS());
    }
    return timeS < outageEndsS;
  }

  /** Time to the next of events that come at random, on average after this long. */
  private double waitS(double meanS) {
    return -meanS * StrictMath.log(1.0 - outages.nextDouble());
  }
}
