/** State that one instance of a service hands over to the next. */
package org.u2sa.service.handover;
