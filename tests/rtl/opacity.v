// The opacity of a sample as a fraction of 2^32 - 1, SPEC.md, section 13. 2 clocks late.
`default_nettype none

module opacity #(
    parameter BITS = 8 // of a channel: 8 or 16
) (
    input  wire             clock,
    input  wire [BITS+15:0] sum, // O
    output wire [31:0]      a32
);
    generate
        if (BITS == 8) begin : from8
            // 257 O, at most 2^32 - 65536, and O / 255 within 2, at most 65535
            wire [31:0] wide, tail;

            add #(.WIDTH(32)) add_wide (clock, {sum, 8'b0}, {8'b0, sum}, wide);
            add #(.WIDTH(32)) add_tail (clock, {16'b0, sum[23:8]}, {24'b0, sum[23:16]}, tail);
            add #(.WIDTH(32)) add_a32 (clock, wide, tail, a32);
        end else begin : from16
            wire [31:0] sum1;

            delay #(.WIDTH(32)) delay_sum (clock, sum, sum1);
            add #(.WIDTH(32)) add_a32 (clock, sum1, {16'b0, sum1[31:16]}, a32);
        end
    endgenerate
endmodule
