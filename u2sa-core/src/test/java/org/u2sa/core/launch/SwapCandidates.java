package org.u2sa.core.launch;

import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.handover.HandOver;

/** Services that are put into one another's place, or that should not be. */
final class SwapCandidates {
  private static final VariableDeclaration<Double> GAIN =
      VariableDeclaration.number("GAIN", "").range(Range.of(0.0, 1.0)).ifAbsent(0.5);
  private static final VariableDeclaration<Double> TRIM =
      VariableDeclaration.number("TRIM", "").ifAbsent(0.0);
  private static final VariableDeclaration<Double> STRICT =
      VariableDeclaration.number("GAIN", "").range(Range.of(0.0, 0.1)).ifAbsent(0.0);

  private SwapCandidates() {}

  /** A service with two variables and something to hand over. */
  public static class First extends EventDrivenService {
    public First(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Worker");
      getVariable(GAIN);
      getVariable(TRIM);
    }

    @Override
    protected void handOver(HandOver state) {
      state.text("FROM", getServiceName());
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  /** One that may take its place, though it knows one variable only. */
  public static class Second extends EventDrivenService {
    final AtomicReference<String> from = new AtomicReference<>("nobody");

    public Second(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Second");
      getVariable(GAIN);
    }

    @Override
    protected void takeOver(HandOver state) {
      from.set(state.text("FROM").orElse("silence"));
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  /** One whose configuration is narrower. */
  public static final class Narrow extends Second {
    public Narrow(ServiceContext context) {
      super(context);
      getVariable(STRICT);
    }
  }

  /** One that cannot be made. */
  public static final class Broken extends Second {
    public Broken(ServiceContext context) {
      super(context);
      throw new IllegalStateException("no such device");
    }
  }

  /** One that wants more than it is handed. */
  public static final class Choosy extends Second {
    public Choosy(ServiceContext context) {
      super(context);
    }

    @Override
    protected void takeOver(HandOver state) {
      throw new IllegalArgumentException("FROM is not enough");
    }
  }

  /** One of another role. */
  public static final class Planner extends EventDrivenService {
    public Planner(ServiceContext context) {
      super(context, ServiceRole.PATH_PLANNER, "Planner");
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }
}
