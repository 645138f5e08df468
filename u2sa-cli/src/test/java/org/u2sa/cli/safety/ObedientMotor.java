package org.u2sa.cli.safety;

import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;

/** An actuator that does as it is told, and moves nothing. */
public final class ObedientMotor extends Actuator {
  /** Called by the launcher. */
  public ObedientMotor(ServiceContext context) {
    super(context, "Motor");
  }

  @Override
  protected void actuate(double percentage) {
    log("moves to " + percentage + " %");
  }

  @Override
  protected void neutral() {
    log("neutral");
  }
}
