/** Missions between ground stations and the Mission Manager, in both directions. */
package org.u2sa.gcs.mavlink.plan;
