/** Services of a running system: which there are, their condition, and who feeds whom. */
package org.u2sa.gcs.services;
