package org.u2sa.core.estimation;

import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;

/**
 * Takes what one sensor measured for the state (thesis 4.5.2.2, 4.6.2.2): each field that the
 * measurement's presence vector names is copied to a new message, each field that a subclass of the
 * message adds too. In: sensed-state. Out: state.
 *
 * <p>It does not fuse: with several sensors, each measurement becomes a state of its own that holds
 * what that sensor saw.
 */
public final class PassThroughStateEstimator extends StateEstimator {
  /** Called by the launcher. */
  public PassThroughStateEstimator(ServiceContext context) {
    super(context, "StateEstimator");
  }

  @Override
  protected Optional<StateInformation> estimate(StateInformation sensed) {
    return Optional.of(sensed.copy());
  }
}
