/** The mission of a running system, as its Mission Manager reports it. */
package org.u2sa.gcs.mission;
