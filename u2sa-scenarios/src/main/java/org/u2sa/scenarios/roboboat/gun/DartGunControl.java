package org.u2sa.scenarios.roboboat.gun;

import java.util.Map;
import java.util.Optional;
import org.u2sa.control.ControlSystem;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;

/**
 * Fires the dart gun while navigation points of its subsystem arrive, and commands its safe
 * position otherwise. In: navigation, state. Out: actuation.
 */
public final class DartGunControl extends ControlSystem {
  /** Name of the subsystem and of its actuator. */
  public static final String SUBSYSTEM = "DART GUN";

  private static final double FIRE_PERCENT = 100.0;
  private static final long ORDER_MICROS = 200_000L; // an order without a newer one is over

  public DartGunControl(ServiceContext context) {
    super(context, "DartGunControl");
  }

  @Override
  protected String subsystem() {
    return SUBSYSTEM;
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    long now = state.timestamp().orElseThrow();
    boolean isOrdered =
        point
            .filter(order -> now - order.timestamp().orElse(Long.MIN_VALUE / 2) <= ORDER_MICROS)
            .isPresent();
    command(SUBSYSTEM, isOrdered ? FIRE_PERCENT : 0.0);
  }

  @Override
  protected Map<String, Double> neutral() {
    return Map.of(SUBSYSTEM, 0.0);
  }
}
