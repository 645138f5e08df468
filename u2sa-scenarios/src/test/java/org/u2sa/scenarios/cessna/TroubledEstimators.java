package org.u2sa.scenarios.cessna;

import java.util.Optional;
import java.util.Set;
import org.u2sa.estimation.StateEstimator;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;

/** Estimators to which something has happened. */
final class TroubledEstimators {
  private TroubledEstimators() {}

  /** Publishes nothing. */
  public static final class Silent extends StateEstimator {
    public Silent(ServiceContext context) {
      super(context, "StateEstimator");
    }

    @Override
    protected Optional<StateInformation> estimate(StateInformation sensed) {
      return Optional.empty();
    }
  }

  /** Does not know where it is, as without a satellite receiver: no position, no velocity. */
  public static final class Lost extends StateEstimator {
    private static final Set<StateField> BY_SATELLITE =
        Set.of(StateField.X, StateField.Y, StateField.X_DOT, StateField.Y_DOT);

    public Lost(ServiceContext context) {
      super(context, "StateEstimator");
    }

    @Override
    protected Optional<StateInformation> estimate(StateInformation sensed) {
      AircraftState from = (AircraftState) sensed;
      AircraftState state = new AircraftState();
      state.referenceFrame(from.referenceFrame());
      for (StateField field : StateField.values()) {
        if (!BY_SATELLITE.contains(field)) {
          from.number(field).ifPresent(value -> state.number(field, value));
        }
      }
      state
          .heightAboveGround(from.heightAboveGround().orElseThrow())
          .calibratedAirspeed(from.calibratedAirspeed().orElseThrow())
          .engineRpm(from.engineRpm().orElseThrow())
          .weightOnWheels(from.weightOnWheels());
      return Optional.of(state);
    }
  }

  /** Knows that it is wrong by 80 m. */
  public static final class Uncertain extends StateEstimator {
    public Uncertain(ServiceContext context) {
      super(context, "StateEstimator");
    }

    @Override
    protected Optional<StateInformation> estimate(StateInformation sensed) {
      StateInformation state = sensed.copy();
      state.xSigma(80.0).ySigma(80.0);
      return Optional.of(state);
    }
  }
}
