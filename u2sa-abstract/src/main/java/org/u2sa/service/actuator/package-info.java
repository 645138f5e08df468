/** What an actuator announces, holds and refuses, and how emergency stops bind it. */
package org.u2sa.service.actuator;
