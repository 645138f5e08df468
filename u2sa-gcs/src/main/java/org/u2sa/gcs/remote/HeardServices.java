package org.u2sa.gcs.remote;

import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.directory.KnownService;
import org.u2sa.service.directory.ServiceDirectory;

/**
 * The services of which a link has heard: tells when a question to everybody is answered by
 * everybody. A service counts from its first word on, answer or health report.
 */
public final class HeardServices {
  /** In this time a service that reports as often as most do has reported twice [s]. */
  private static final double LISTEN_S = 0.6;

  private final Clock clock;
  private final ServiceDirectory directory;
  private final long beganMicros;

  private HeardServices(RemoteLink link) {
    clock = link.clock();
    directory = new ServiceDirectory(clock, link::publish);
    beganMicros = clock.micros();
  }

  /** Begins to listen, and asks all services who they are. */
  public static HeardServices begin(RemoteLink link) {
    HeardServices heard = new HeardServices(link);
    for (Channel<?> channel : ServiceDirectory.CHANNELS) {
      link.listen(channel, heard.directory::take);
    }
    heard.directory.ask();
    return heard;
  }

  /**
   * Whether each service that was heard is among these, and there was time to hear them all. False
   * while nobody was heard.
   */
  public boolean areAmong(Set<String> names) {
    directory.refresh();
    Set<String> heard =
        directory.services().stream().map(KnownService::name).collect(Collectors.toSet());
    return clock.micros() - beganMicros >= Clock.micros(LISTEN_S)
        && !heard.isEmpty()
        && names.containsAll(heard);
  }
}
