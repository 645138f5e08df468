package org.u2sa.drivers.ioio;

import org.u2sa.service.U2SAService;

/** Says once in a service's log and health report when something goes, and when it is back. */
final class Presence {
  private final U2SAService service;
  private final String what;
  private boolean wasThere = true; // so that what is absent from the start is said, too
  private boolean wasSaid;

  Presence(U2SAService service, String what) {
    this.service = service;
    this.what = what;
  }

  /** It is there. */
  void there(String details) {
    if (!wasThere || !wasSaid) {
      service.log(what + " is there" + details);
    }
    wasThere = true;
    wasSaid = true;
  }

  /** It is not. */
  void gone(String why) {
    if (wasThere) {
      service.trouble(what + " is lost: " + why);
    }
    wasThere = false;
    wasSaid = true;
  }
}
