/** State transferred from one instance of a service to the next. */
package org.u2sa.service.handover;
