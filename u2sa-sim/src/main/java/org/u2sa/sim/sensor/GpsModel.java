package org.u2sa.sim.sensor;

import java.util.Random;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/** GNSS error model: white noise, slowly varying bias, outages. */
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

  /** Uses the random streams {@code gps} and {@code gps outages}. */
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
   * Computes the next position. Noise advances during outages, so an outage does not change later
   * errors.
   *
   * @param timeS simulated time, strictly increasing [s]
   * @param blocked whether the sky is blocked
   */
  public GpsSample sample(double timeS, VehicleTruth truth, boolean blocked) {
    double dtS = timeS - lastS;
    lastS = timeS;
    double east = truth.position().x() + biasEast.step(dtS) + p.whiteM() * noise.nextGaussian();
    double north = truth.position().y() + biasNorth.step(dtS) + p.whiteM() * noise.nextGaussian();
    double up =
        truth.position().z()
            + biasUp.step(dtS)
            + p.whiteM() * p.verticalFactor() * noise.nextGaussian();
    double eastMps = truth.velocity().x() + p.velocityMps() * noise.nextGaussian();
    double northMps = truth.velocity().y() + p.velocityMps() * noise.nextGaussian();
    double upMps = truth.velocity().z() + p.velocityMps() * noise.nextGaussian();
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

  /** Time to the next event of a Poisson process with this mean interval. */
  private double waitS(double meanS) {
    return -meanS * StrictMath.log(1.0 - outages.nextDouble());
  }

  /**
   * A first-order Gauss-Markov bias (Gelb, Applied Optimal Estimation, chapter 2), discretised
   * exactly and stationary from the start.
   */
  static final class GaussMarkov {
    private final double sigma;
    private final double tauS;
    private final Random noise;
    private double value;

    /**
     * @param sigma standard deviation
     * @param tauS correlation time [s]
     */
    GaussMarkov(double sigma, double tauS, Random noise) {
      this.sigma = sigma;
      this.tauS = tauS;
      this.noise = noise;
      this.value = sigma * noise.nextGaussian();
    }

    double step(double dtS) {
      double kept = StrictMath.exp(-dtS / tauS);
      value = kept * value + sigma * StrictMath.sqrt(1.0 - kept * kept) * noise.nextGaussian();
      return value;
    }
  }
}
