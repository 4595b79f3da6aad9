// Writes exp_power.hex, the table of transmittance.v: entry i is round(2^(31 + i/64)).
//
// n is that number exactly if it is the greatest with n - 1/2 <= 2^(31 + i/64), which is
// (2 n - 1)^64 <= 2^(32 * 64 + i): a comparison of whole numbers of 33 * 64 bits.
`default_nettype none

module exp_power;
    localparam BITS = 33 * 64;

    reg [BITS-1:0] power, bound;
    reg [31:0]     n;
    integer        i, bit_number, square;

    initial begin
        $write("// exp_power[i] = round(2^(31 + i/64)), u32.31, i = 0 .. 63; ");
        $display("SPEC.md, section 27");
        for (i = 0; i < 64; i = i + 1) begin
            bound = {{BITS-1{1'b0}}, 1'b1} << (32 * 64 + i);
            n = 0;
            for (bit_number = 31; bit_number >= 0; bit_number = bit_number - 1) begin
                n[bit_number] = 1;
                power = {{BITS-33{1'b0}}, n, 1'b0} - 1;
                for (square = 0; square < 6; square = square + 1) power = power * power;
                if (power > bound) n[bit_number] = 0;
            end
            $display("%h", n);
        end
    end
endmodule
