package org.u2sa.cli.services;

import java.util.concurrent.CountDownLatch;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Never comes to its end: hangs where it should close its resources. */
public final class Stubborn extends EventDrivenService {
  private final CountDownLatch never = new CountDownLatch(1);

  public Stubborn(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "Stubborn");
  }

  @Override
  public void callback(U2SAData data) {
    unexpected(data);
  }

  @Override
  protected void release() {
    try {
      never.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
