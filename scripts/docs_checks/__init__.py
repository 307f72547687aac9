# SPDX-License-Identifier: MIT
"""What scripts/check_docs asks of README.md and of the pages in docs/."""
