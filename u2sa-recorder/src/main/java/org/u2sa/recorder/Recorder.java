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
 * Records every message of a system into MCAP files (thesis 3.2.1.5). In: all channels, by a
 * connection of its own that hands messages over as they are published, none replaced by a newer
 * one. Out: nothing but the contract's messages; health tells what was dropped.
 *
 * <p>Serves in a system file as well, on a phone too.
 */
public final class Recorder extends EventDrivenService implements Execution.Keeper {
  private static final String LIBRARY = "u2sa";

  private final Recording recording;
  private final KeptExecutions executions;
  private final boolean keepsExecutions;
  private final Connection connection;
  private final Optional<LocalBus> bus;

  /** A recorder that says nothing of the run but its seed. */
  public Recorder(ServiceContext context) {
    this(context, new RecordingFacts());
  }

  /**
   * Connects; recording begins at once, so that nothing of what follows is missed.
   *
   * @param facts about the run, to be recorded with it
   * @throws CommunicationException if there is no Communication Manager
   */
  public Recorder(ServiceContext context, RecordingFacts facts) {
    super(context, ServiceRole.OBSERVER, "Recorder");
    RecorderSettings settings = settings(RecorderSettings.class).get();
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
      trouble("not allowed to hear, and so not recorded: " + String.join(", ", refused));
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
   * Ends the service, and returns when its last file is whole. {@link #kill} waits for a service's
   * thread only for a while, in which a busy machine may not have written all.
   */
  public void finish() {
    kill();
    recording.close();
  }

  /** The files, oldest first; for when the service has ended. */
  public List<Path> files() {
    return recording.written();
  }

  /** Messages so far, those dropped included. */
  public long messages() {
    return recording.taken();
  }

  /** Messages that came faster than they could be recorded, and are not in the file. */
  public long dropped() {
    return recording.dropped();
  }
}
