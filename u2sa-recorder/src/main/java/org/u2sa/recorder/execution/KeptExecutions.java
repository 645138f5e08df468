package org.u2sa.recorder.execution;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.u2sa.service.Execution;
import org.u2sa.service.ServiceContext;

/** Starts and names the executions of a recording. */
public final class KeptExecutions implements ServiceContext.ExecutionKeeper {
  private final BiConsumer<String, ExecutionStart> starts;
  private final Consumer<ExecutionPart> parts;
  private final Consumer<String> trouble;
  private final Map<String, Integer> lives = new HashMap<>(); // by service; guarded by this

  /**
   * @param starts receives an execution's name and start
   * @param parts receives the parts of all executions
   * @param trouble notified of executions that cannot be kept
   */
  public KeptExecutions(
      BiConsumer<String, ExecutionStart> starts,
      Consumer<ExecutionPart> parts,
      Consumer<String> trouble) {
    this.starts = starts;
    this.parts = parts;
    this.trouble = trouble;
  }

  @Override
  public Optional<Execution> keep(String className, ServiceContext context) {
    try {
      ExecutionStart before = ExecutionStart.before(className, context);
      return Optional.of(
          new KeptExecution(
              context.clock(), context.isSwap(), made -> begin(made, before, context), parts));
    } catch (IOException e) {
      trouble.accept(className + " cannot be executed again: " + e);
      return Optional.empty();
    }
  }

  private void begin(KeptExecution made, ExecutionStart before, ServiceContext context) {
    if (!KeptExecution.isRepeatable(made.service())) {
      return;
    }
    try {
      ExecutionStart start = before.after(made, context);
      String name = nameOfNext(made.service().getServiceName());
      starts.accept(name, start);
      made.keepAs(name);
    } catch (IOException e) {
      trouble.accept(made.service().getServiceName() + " cannot be executed again: " + e);
    }
  }

  /** Service name; after a restart or swap with an instance number appended. */
  private synchronized String nameOfNext(String service) {
    int life = lives.merge(service, 1, Integer::sum);
    return life == 1 ? service : service + "#" + life;
  }
}
