package org.u2sa.recorder;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.recorder.execution.KeptExecutions;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.Execution;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Records every message of a system into MCAP files (thesis 3.2.1.5). In: all channels, over a
 * separate connection that delivers every message on publication, without superseding older ones.
 * Out: only the messages every service publishes; health reports dropped messages.
 *
 * <p>Can also be listed in a system file, including on a phone.
 */
public final class Recorder extends EventDrivenService implements ServiceContext.ExecutionKeeper {
  private static final String LIBRARY = "u2sa";

  private final Recording recording;
  private final KeptExecutions executions;
  private final boolean keepsExecutions;
  private final Connection connection;
  private final Optional<LocalBus> bus;

  /** Creates a recorder that stores no facts about the run except its seed. */
  public Recorder(ServiceContext context) {
    this(context, new RecordingFacts());
  }

  /**
   * Connects and starts recording immediately, so that no later message is missed.
   *
   * @param facts facts about the run, stored in the recording
   * @throws CommunicationException if no Communication Manager is reachable
   */
  public Recorder(ServiceContext context, RecordingFacts facts) {
    super(context, ServiceRole.OBSERVER, "Recorder");
    RecorderVariables settings = settings(RecorderVariables.class).get();
    facts.say("run", "system", context.systemId());
    facts.say("run", "seed", Long.toString(context.seed()));
    Path file = context.logDirectory().resolve(settings.file());
    recording =
        new Recording(
            context.systemId(),
            context.clock(),
            settings,
            new RecordingFiles(file, settings, LIBRARY, facts, this::tell),
            this::tell);
    executions = new KeptExecutions(recording::begin, recording::add, this::tell);
    keepsExecutions = settings.keepsExecutions();
    Transport transport =
        context
            .transport()
            .orElseThrow(() -> new CommunicationException("a recorder needs a transport"));
    connection = transport.connect(getServiceName() + "-tap", recording);
    bus = transport instanceof LocalBus direct ? Optional.of(direct) : Optional.empty();
    List<String> refused = new ArrayList<>();
    for (Channel<?> channel : Channels.all()) {
      if (!connection.subscribe(channel)) {
        refused.add(channel.name());
      }
    }
    bus.ifPresent(direct -> direct.attach(recording));
    recording.start();
    if (!refused.isEmpty()) {
      trouble("no permission to receive, so not recorded: " + String.join(", ", refused));
    }
  }

  @Override
  public Optional<Execution> keep(String className, ServiceContext context) {
    return keepsExecutions ? executions.keep(className, context) : Optional.empty();
  }

  private void tell(String what) {
    trouble(what);
    remark("recording", what);
  }

  @Override
  protected void release() {
    bus.ifPresent(direct -> direct.detach(recording));
    connection.close();
    recording.close();
    log(
        LogLevelEnum.INFO,
        recording.taken()
            + " messages taken, "
            + recording.dropped()
            + " of them dropped, "
            + recording.notWritten()
            + " not written, into "
            + recording.written());
  }

  /**
   * Ends the service and waits until its last file is complete. {@link #kill} has a timeout, within
   * which a busy machine may not have written everything.
   */
  public void finish() {
    kill();
    recording.close();
  }

  /** Recorded files, oldest first. Call after the service has ended. */
  public List<Path> files() {
    return recording.written();
  }

  /** Number of messages so far, including dropped ones. */
  public long messages() {
    return recording.taken();
  }

  /** Number of messages dropped because they arrived faster than they could be recorded. */
  public long dropped() {
    return recording.dropped();
  }
}
